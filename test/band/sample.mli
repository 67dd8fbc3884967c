(** Pictures, their bands and folders for these tests. *)

open Raylab_tracer
open Raylab_picture
open Raylab_band

val whole : width:int -> height:int -> Band.whole
(** [whole ~width ~height] is a picture of this size of some scene. *)

val picture : width:int -> height:int -> Picture.t
(** [picture ~width ~height] has another colour in every pixel, as far as there
    are colours. *)

val rows : Picture.t -> first:int -> last:int -> Picture.t
(** [rows picture ~first ~last] is these rows of it. *)

val save :
  ?whole:Band.whole ->
  Picture_file.format ->
  string ->
  Picture.t ->
  first:int ->
  last:int ->
  unit
(** [save format path picture ~first ~last] writes that band of [picture],
    which is [whole], by default {!val-whole} of its size. *)

val in_new_folder : (string -> unit) -> unit -> unit
(** [in_new_folder f ()] is [f folder] for an empty folder, which is removed
    afterwards with the files in it. *)

val read : string -> string
(** [read path] is the bytes of a file. *)

val write : string -> string -> unit
(** [write path text] makes [text] the bytes of a file. *)

val formats : Picture_file.format list
(** [formats] is all of them. *)

val test : string -> (string -> unit) -> unit Alcotest.test_case
(** [test name f] is a test of [f] {!in_new_folder}. *)

val for_each :
  string ->
  (Picture_file.format -> string -> unit) ->
  unit Alcotest.test_case list
(** [for_each name f] is a {!val-test} of each format. *)

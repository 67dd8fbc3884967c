(** Pictures of small scenes, for these tests. *)

open Raylab_scene
open Raylab_tracer

val centre :
  ?background:Color.t ->
  ?ambient:Color.t ->
  ?ray_depth:int ->
  ?lights:Light.t list ->
  Object.t list ->
  Color.t
(** [centre objects] is the colour of the ray from (0, 0, -1) along the z axis
    in the scene with these [objects]. *)

val sun : ?intensity:float -> float -> float -> float -> Light.t
(** [sun x y z] is white light that travels along [(x, y, z)], of intensity 1
    unless told otherwise. *)

val bulb : ?intensity:float -> float -> float -> float -> Light.t
(** [bulb x y z] is white light from the point [(x, y, z)]. *)

val picture : Scene.t -> Picture.t
(** [picture scene] is the picture of [scene], from one domain. *)

val drawing : (int * int * int -> char) -> Picture.t -> string list
(** [drawing letter picture] is [picture] as letters, a string a row. *)

val pixels : Picture.t -> (int * int) list
(** [pixels picture] is the coordinates of all pixels. *)

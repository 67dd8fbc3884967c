(** The files of scenes on the disk. *)

open Raylab_source

val access : ?allow:string list -> string -> Access.t
(** [access ~allow path] reaches, for the scene at [path], regular files in its
    folder and below, or of standard input and other streams in the current
    one; and in the folders [allow] and below. That is after all links are
    resolved. No other file is opened. *)

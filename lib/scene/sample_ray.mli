(** The rays of a picture: those of the samples of each pixel. *)

open Raylab_geometry

val aim :
  Scene.t -> Camera.centres -> x:int -> y:int -> int -> Raw_ray.t -> unit
(** [aim scene centres ~x ~y k ray] makes [ray] the ray of sample [k] of pixel
    [(x, y)], y from the top, with its seed. It goes through the place of the
    pixel that {!Spread} says, for sample 0 its centre.

    If the film takes several samples and the lens is open, it starts at a
    point of the lens, and meets the ray of a pinhole in the plane in focus. *)

val make : Scene.t -> x:int -> y:int -> int -> Ray.t
(** [make scene ~x ~y k] is that ray. *)

(** How far the picture in a window is. *)

type t =
  | Reading  (** the scene; nothing of it is shown yet *)
  | Rendering
  | Took of float  (** it is whole, and took so many seconds *)
  | In_error of string  (** the scene is, and this is what is wrong *)

val title : t -> name:string -> size:int * int -> part:float -> string
(** [title stage ~name ~size ~part] is the title of the window, such as
    [first.scene, 640 x 480: 37 %], where [part] of the picture is there. *)

(** What one wants to know of a mesh before one uses it. *)

(** The type for ways in which the normals of most of its area point. *)
type normals =
  | Outward
  | Inward
  | Along of Direction.t  (** of a mesh that is open: all about one way *)
  | Anyhow

type t = {
  triangles : int;
  box : Box3.t;
  opening : string option;  (** {!Mesh.opening} *)
  normals : normals;
      (** of a closed mesh this is certain, as far as it does not go through
          itself; of one that is open it is a guess *)
}
(** The type for surveys. *)

val make : Mesh.t -> t
(** [make mesh] is the survey of [mesh]. *)

val to_string : t -> string
(** [to_string survey] is
    ["12 triangles from (-1, -1, -1) to (1, 1, 1), closed; its normals point
     outward"]. *)

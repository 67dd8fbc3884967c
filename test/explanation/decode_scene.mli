(** The scene's things in the JSON of explanations, and plain values. *)

open Raylab_geometry
open Raylab_scene

exception Wrong of string
(** A place where the JSON does not follow the schema: a member is missing,
    unknown, or of another type. *)

val wrong : string -> 'a
(** [wrong place] raises {!Wrong}. *)

(** {1 Plain values}

    A number that is null is NaN. *)

val float : Yojson.Safe.t -> float
val int : Yojson.Safe.t -> int
val bool : Yojson.Safe.t -> bool
val text : Yojson.Safe.t -> string
val list : (Yojson.Safe.t -> 'a) -> Yojson.Safe.t -> 'a list
val optional : (Yojson.Safe.t -> 'a) -> Yojson.Safe.t -> 'a option
val vector : Yojson.Safe.t -> Vec3.t
val color : Yojson.Safe.t -> Color.t
val direction : Yojson.Safe.t -> Direction.t

val members : string list -> Yojson.Safe.t -> string -> Yojson.Safe.t
(** [members names json] looks up the members of an object that has exactly
    [names], in this order. *)

val member : string -> Yojson.Safe.t -> Yojson.Safe.t
(** [member name json] is this member of an object. *)

val has : string -> Yojson.Safe.t -> bool
(** [has name json] is whether it has this member. *)

val kind : Yojson.Safe.t -> string
(** [kind json] is the member [kind]. *)

(** {1 Objects} *)

val place_members : Yojson.Safe.t -> string list
(** [place_members json] is the names of the members that tell a place. *)

val origin : Yojson.Safe.t -> Origin.t
(** [origin json] is where in {!Test_support.Build.files} that place is. *)

val object_ : Yojson.Safe.t -> int * Object.t * Provenance.t option
(** [object_ json] is an OBJECT, its number and its place. *)

val primitive :
  Yojson.Safe.t ->
  Object.t ->
  string list * Raylab_tracer.Explain.primitive option
(** [primitive json o] is the primitive of [o] that [json] has, and the name of
    the member that tells of it, if it has one. *)

(** Meshes: surfaces of triangles with common corners, of which there may be
    millions. A mesh is in memory once, however many objects of a scene show
    it.

    A ray that meets an edge or a corner meets exactly one of the triangles
    around it that it passes through, so that none slips through and closed
    meshes are entered and left by turns: ray and triangles are brought to two
    dimensions in a way that is the same for all triangles (S. Woop, C. Benthin
    and I. Wald, {e Watertight ray/triangle intersection}, JCGT 2013), and a
    ray that meets an edge exactly is taken for one a little beside it.

    The part of a mesh that a ray meets is the triangle, counted from 0 in the
    order of the {!Facets}. *)

type t
(** The type for meshes. *)

val make : ?domains:int -> ?smooth:bool -> name:string -> Facets.t -> t
(** [make ~domains ~smooth ~name facets] is the mesh of [facets], at least one,
    called [name]: that of its file. Its hierarchy is built on at most
    [domains] domains, by default 1. If it is [smooth], by default it is not,
    each corner has a normal of length 1.

    Raises [Invalid_argument] if the facets are not as {!Facets.t} says, there
    is no triangle, or it is [smooth] and a corner has no normal. *)

val name : string
(** [name] is ["mesh"]. *)

val file : t -> string
(** [file mesh] is what it is called. *)

val facets : t -> Facets.t
(** [facets mesh] is what it was made of. *)

val is_smooth : t -> bool
(** [is_smooth mesh] is whether it is shaded by the normals at its corners. *)

(** {1 What it is} *)

val box : t -> Box3.t
(** [box mesh] is the box around it. *)

val open_edge : t -> int option
(** [open_edge mesh] is a triangle with an edge that is not that of exactly
    two; [None] if the mesh is closed. *)

val volume : t -> float
(** [volume mesh] is {!Mesh_edges.volume}. *)

(** {1 What is hit} *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer mesh ray meeting ~number] is as {!Shape.offer}. *)

val crossings : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings mesh ray crossings] is as {!Shape.crossings_raw}. Of a mesh that
    is not closed there are none. *)

val settle : t -> part:int -> Raw_ray.t -> Spot.t -> unit
(** [settle mesh ~part ray spot] is as {!Shape.settle}. The outward normal is
    that of the triangle as it is wound, [(B - A) x (C - A)]. *)

val depth : t -> Vec3.t -> float
(** [depth mesh point] is as {!Shape.depth}. *)

(** {1 What is told} *)

val part : t -> int -> string
(** [part mesh k] is what the triangle [k] is called, such as
    ["face 12 of bunny.obj, line 40"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters mesh] is as {!Shape.parameters}: its file, and the word
    [smooth]. *)

val some_points : t -> Vec3.t list
(** [some_points mesh] is some of its corners, for drawings. *)

val place : t -> float array
(** [place mesh] is as {!Shape.place}. *)

val equal : t -> t -> bool
(** [equal a b] is whether they are made of the same facets, and both smooth or
    both not. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [mesh "bunny.ply" smooth]. *)

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

val make : ?domains:int -> name:string -> Facets.t -> t
(** [make ~domains ~name facets] is the mesh of [facets], at least one, called
    [name]: that of its file. It is not smooth. Its hierarchy is built on at
    most [domains] domains, by default 1.

    Raises [Invalid_argument] if the facets are not as {!Facets.t} says, or
    there is no triangle. *)

val smooth : Facets.t -> t -> t
(** [smooth facets mesh] is [mesh] shaded by the normals of [facets], which are
    the same triangles, with a normal of length 1 at each corner.

    Raises [Invalid_argument] if they are not. *)

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

val open_edge : t -> Mesh_edges.edge option
(** [open_edge mesh] is {!Mesh_edges.val-open_edge}; [None] if it is closed. *)

val is_closed : t -> bool
(** [is_closed mesh] is whether it has an inside: {!open_edge} is [None]. *)

val volume : t -> float
(** [volume mesh] is {!Mesh_edges.volume}, from one of its corners. *)

(** {1 What is hit} *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer mesh ray meeting ~number] is as {!Shape.offer}. *)

val crossings : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings mesh ray crossings] is as {!Shape.crossings_raw}. A mesh that is
    not closed is crossed twice at each place, in and out. *)

val settle : t -> part:int -> Raw_ray.t -> Spot.t -> unit
(** [settle mesh ~part ray spot] is as {!Shape.settle}. The outward normal is
    that of the triangle as it is wound, [(B - A) x (C - A)]. *)

val depth : t -> Vec3.t -> float
(** [depth mesh point] is as {!Shape.depth}. *)

(** {1 What is told} *)

val part : t -> int -> string
(** [part mesh k] is what the triangle [k] is called, such as
    ["face 12 (line 40 of bunny.obj)"]. *)

val opening : t -> string option
(** [opening mesh] is where it is open, if it is not closed: a face has an edge
    that no other has, or more than one. *)

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

(** Shapes: what an object of a scene looks like, without its surface.

    A new shape is a module of its own like {!module-Sphere}, a constructor
    here, and a case in each function below that the compiler asks for; see
    [doc/adding-a-shape.md]. Nothing else that renders or explains a scene
    knows which shapes there are, but for the hierarchy, which keeps spheres as
    numbers. *)

(** The type for shapes. *)
type t =
  | Sphere of Sphere.t
  | Plane of Plane.t
  | Box of Box.t
  | Cylinder of Cylinder.t
  | Cone of Cone.t
  | Torus of Torus.t
  | Disc of Disc.t
  | Triangle of Triangle.t
  | Quad of Quad.t
  | Mesh of Mesh.t
  | Placed of t Placed.t
      (** what a change has made another kind of shape; the own shape is
          neither [Placed] nor [Solid] *)
  | Solid of t Solid.t
      (** what is put together; no member is a [Solid] again *)

val sphere : centre:Vec3.t -> radius:float -> t
(** [sphere ~centre ~radius] is {!Sphere.make} as a shape. *)

val plane : point:Vec3.t -> normal:Vec3.t -> t
(** [plane ~point ~normal] is {!Plane.make} as a shape; [normal] may have any
    length.

    Raises [Invalid_argument] if a coordinate is not finite or [normal] is the
    zero vector. *)

val box_between : corner:Vec3.t -> opposite:Vec3.t -> t
(** [box_between ~corner ~opposite] is {!Box.make} as a shape. *)

val cylinder : Vec3.t -> Vec3.t -> radius:float -> t
(** [cylinder a b ~radius] is {!Cylinder.make} as a shape. *)

val cone : Vec3.t -> float -> Vec3.t -> float -> t
(** [cone a radius_a b radius_b] is {!Cone.make} as a shape. *)

val torus : centre:Vec3.t -> axis:Vec3.t -> ring:float -> tube:float -> t
(** [torus ~centre ~axis ~ring ~tube] is {!Torus.make} as a shape; [axis] may
    have any length.

    Raises [Invalid_argument] where {!Torus.make} does, or if [axis] is the
    zero vector. *)

val disc : centre:Vec3.t -> normal:Vec3.t -> radius:float -> t
(** [disc ~centre ~normal ~radius] is {!Disc.make} as a shape; [normal] may
    have any length.

    Raises [Invalid_argument] where {!Disc.make} does, or if [normal] is the
    zero vector. *)

val triangle : Vec3.t -> Vec3.t -> Vec3.t -> t
(** [triangle a b c] is {!Triangle.make} as a shape. *)

val quad : corner:Vec3.t -> edge:Vec3.t -> other:Vec3.t -> t
(** [quad ~corner ~edge ~other] is {!Quad.make} as a shape. *)

val transformed : ?keep_own:bool -> Change.t -> t -> t
(** [transformed ~keep_own change shape] is [shape] as [change] puts it. It
    stays of its kind if it can, so that its numbers are those of its new
    place; else, or with [keep_own], it is {!constructor-Placed}, and keeps its
    own coordinates.

    Raises [Invalid_argument] where a number is no longer what it must be. *)

(** {1 Solids} *)

val is_solid : t -> bool
(** [is_solid shape] is whether it has an inside: a half-space, for a plane. *)

val opening : t -> string option
(** [opening shape] is where a mesh is open that is therefore no solid;
    {!Mesh.opening}. *)

val solid : t Solid.tree -> t
(** [solid tree] is what [tree] says of its members. A solid among them is as
    if its own tree stood there.

    Raises [Invalid_argument] if a member is not {!is_solid}, or an
    intersection or a difference is empty. *)

val with_members : t array -> t -> t
(** [with_members members shape] is the solid [shape] with as many other
    members; any other shape as it is. *)

val with_tolerance : float -> t -> t
(** [with_tolerance e shape] is [shape]; if it is a {!constructor-Solid}, faces
    of its members coincide within [e]. *)

(** {1 What is hit}

    All on registers, for inner loops: nothing here allocates. *)

val box : t -> Box3.t option
(** [box shape] is a box that holds all of [shape], the smaller the better;
    [None] if there is none, since [shape] has no end. *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer shape ray meeting ~number] is {!Meeting.offer} of the least [t > 0]
    at which [ray] meets [shape], which goes by [number], and of the part that
    it meets there. *)

val settle : t -> part:int -> Raw_ray.t -> Spot.t -> unit
(** [settle shape ~part ray spot] puts into [spot] what [shape] knows of the
    place where [ray], whose reach ends there, meets its [part]: the point, as
    exactly on [shape] as can be, the outward normal, the own point and the
    size. *)

val crossings_raw : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings_raw shape ray crossings] puts all places where the line of [ray]
    crosses [shape] into [crossings]. The ray's reach is not looked at. *)

(** {1 The same of values} *)

val nearest : t -> Ray.t -> (float * int) option
(** [nearest shape ray] is the least distance greater than 0 at which [ray]
    meets [shape], and the part that it meets. The ray's reach is not looked
    at. *)

val crossings : t -> Ray.t -> Crossings.crossing list
(** [crossings shape ray] is all places where the line of [ray] crosses
    [shape], in ascending order; those at negative distances lie behind the
    ray's origin. The ray's reach is not looked at. *)

val intersections : t -> Ray.t -> float list
(** [intersections shape ray] is the distances of {!crossings}. *)

val normal : t -> ?part:int -> Vec3.t -> Direction.t
(** [normal shape ~part point] is the unit normal of [part], by default 0, at
    [point], a point of [shape]: outward for a solid, else as given. *)

val depth : t -> Vec3.t -> float
(** [depth shape point] is how far inside of [shape] [point] is, negative
    outside; [neg_infinity] for a shape that is not closed. Each way from a
    point inside to one outside hits [shape]. *)

(** {1 What is told} *)

val name : t -> string
(** [name shape] is the scene language's word for it: ["sphere"], ["plane"]. A
    {!constructor-Placed} one has the name of what it was, a
    {!constructor-Solid} that of its outermost grouping. *)

val part : t -> int -> string option
(** [part shape k] is what its part [k] is called, such as ["top"]; [None] if
    there is no more to say than {!name}. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters shape] is what the scene language writes after {!name}, in that
    order, each with its name; of a {!constructor-Placed} one in its own
    coordinates; nothing for a {!constructor-Solid}. *)

val modifiers : t -> Change.modifier list
(** [modifiers shape] is what the scene language writes after the surface: what
    has brought a {!constructor-Placed} shape to its place. *)

val outline : t -> Outline.t
(** [outline shape] is how [shape] is drawn and spoken of. *)

val equal : t -> t -> bool
(** [equal a b] is whether [a] and [b] are the same shape with the same
    numbers. *)

val place : t -> float array
(** [place shape] is numbers that are the same for shapes that fill the same
    place, and, as far as about nine digits reach, for no others. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [sphere centre (0, 0, 6) radius 1] and
    [plane point (0, -1, 0) normal (0, 1, 0)], and modifiers after that. *)

(** Straight round solids: the mathematics that cylinders and cones share. *)

type t = private {
  a : Vec3.t;
  b : Vec3.t;  (** the centres of the two ends *)
  radius_a : float;
  radius_b : float;  (** the radii there *)
  axis : Direction.t;  (** from [a] to [b] *)
  length : float;  (** that of the way from [a] to [b] *)
  slope : float;  (** by how much the radius grows along the axis *)
  across : float;
  along : float;
      (** the outward normal of the wall, across the axis and along it: the
          direction of [(1, -slope)] *)
}
(** The type for such solids. All numbers but the slope are finite, [a] and [b]
    differ, and the radii are at least 0, and one of them is more. *)

val make : Vec3.t -> float -> Vec3.t -> float -> t
(** [make a radius_a b radius_b] is the solid from [a] to [b].

    Raises [Invalid_argument] if a number is not as it must be. *)

val box : t -> Box3.t
(** [box frustum] is a box around it. *)

(** {1 What is hit}

    With [w] the axis, [l] the length and [k] the slope, a point [p] is at the
    height [y = (p - a) . w], the way from the axis to it is [q = p - a - y w],
    and the solid is the points with

    [0 <= y <= l] and [|q| <= R + k y], where [R] is the radius at [a].

    A line is between the two ends in one piece, from [-y / d . w] to
    [(l - y) / d . w]. With [e = d - (d . w) w], [h = k (d . w)] and
    [g = R + k y] for its origin, it meets the wall where

    [A t^2 + 2 B t + C = 0], with [A = e . e - h^2], [B = q . e - h g] and
    [C = q . q - g^2].

    The discriminant is not [B^2 - A C], where digits are lost, but what that
    is when multiplied out, [|g e - h q|^2 - |q x e|^2]; and the roots are
    [Q / A] and [C / Q] with [Q = -B] plus or minus its root, whichever is the
    larger (W. H. Press and others, {e Numerical Recipes}, 5.6). The origin is
    moved to the point of the line that is nearest to the middle of the solid
    first, as for spheres ({!Sphere}).

    If [A > 0] the line is within the wall between the roots. Otherwise it is
    steeper than the wall and within it from the greater root on if [h > 0],
    and up to the lesser one if [h < 0]: beyond the other one it is in the
    wall's mirror image behind the tip. The solid is convex, so it is in it
    from the later of the two beginnings to the sooner of the two ends.

    Part 0 is the wall, 1 the end at [a] and 2 that at [b]. *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer frustum] is {!Shape.offer}. *)

val settle : t -> part:int -> Raw_ray.t -> Spot.t -> unit
(** [settle frustum] is {!Shape.settle}: on the wall the spot is the point at
    the same height and in the same direction from the axis as the end of the
    ray, where [q / |q| - k w] is the direction of the normal; on an end it is
    {!Flat.settle}. The size is the largest of radii and length. *)

val crossings : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings frustum] is {!Shape.crossings_raw}: none or two. *)

val depth : t -> Vec3.t -> float
(** [depth frustum point] is how far inside [point] is; negative outside. *)

(** {1 What is told} *)

val circles : t -> (Vec3.t * float) list
(** [circles frustum] is its two ends. *)

val part : int -> string option
(** [part k] is what part [k] is called: an end is ["first end"] or
    ["second end"], and the wall has no word of its own. *)

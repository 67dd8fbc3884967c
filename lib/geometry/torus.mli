(** Tori: rings. *)

type t = private {
  centre : Vec3.t;
  axis : Direction.t;
  ring : float;
  tube : float;
}
(** The type for tori: a centre, an axis, the radius of the circle in the
    middle of the tube and that of the tube, all finite, with
    [0 < tube <= ring]. *)

val make : centre:Vec3.t -> axis:Direction.t -> ring:float -> tube:float -> t
(** [make ~centre ~axis ~ring ~tube] is the torus around [axis].

    Raises [Invalid_argument] if a number is not as it must be. *)

val name : string
(** [name] is the scene language's word, ["torus"]. *)

val parameters : t -> (string * Parameter.t) list
(** [parameters torus] is what is written after its word, in that order, each
    with its name: ["centre"], ["axis"], ["ring"] and ["tube"]. *)

val box : t -> Box3.t
(** [box torus] is a box around it: along each axis it reaches
    [ring * sqrt (1 - k^2) + tube] far, with [k] the axis's number there. *)

(** {1 What is hit}

    With [w] the axis, a point [p] is at the height [y = (p - centre) . w]; the
    way from the axis to it is [q = p - centre - y w], and the torus is the
    points where [a(p) = (|q| - ring)^2 + y^2 - tube^2] is 0, with its inside
    where that is negative.

    Along a line, with the origin moved to its point [v] nearest to the centre
    and all lengths as parts of [ring + tube], [a] times
    [(|q| + ring)^2 + y^2 - tube^2], which is not negative, is the quartic

    [f(s) = (s^2 + k)^2 - 4 ring^2 (s^2 + v . v - (y + s w . d)^2)] with
    [k = v . v + ring^2 - tube^2],

    without a cube. Its roots are found by numbers where it turns, in the way
    of C. Yuksel, {e High-Performance Polynomial Root Finding for Graphics},
    2022: between two neighbouring roots of its derivative, a cubic, [f] only
    rises or only falls, so there is a root if the signs at both ends differ,
    and it is enclosed there; and the roots of the cubic are found likewise,
    between those of its derivative, which is a square. Enclosed roots come of
    Newton's method, with bisection where that leaves its interval or is slow
    (W. H. Press and others, {e Numerical Recipes}, 9.4). Signs and roots of
    [f] are those of [a] itself, which loses no digits. So roots come in pairs,
    in and out, also where a line all but touches; and no method for quartics
    that takes square roots of complex numbers, and loses digits to them, is
    needed. *)

val offer : t -> Raw_ray.t -> Meeting.t -> number:int -> unit
(** [offer torus] is {!Shape.offer}. *)

val settle : t -> Raw_ray.t -> Spot.t -> unit
(** [settle torus] is {!Shape.settle}: the spot is the point of the torus that
    is nearest to the end of the ray, and the normal points away from the
    middle of the tube. The size is [ring + tube]. *)

val crossings : t -> Raw_ray.t -> Crossings.t -> unit
(** [crossings torus] is {!Shape.crossings_raw}: none, two or four. *)

val depth : t -> Vec3.t -> float
(** [depth torus point] is how far inside of [torus] [point] is; negative
    outside. *)

(** {1 What is told} *)

val pieces : t -> Vec3.t list list
(** [pieces torus] is 24 pieces of the ring, all around, each by points that
    enclose it. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints [torus centre (0, 0, 6) axis (0, 1, 0) ring 2 tube 0.5]. *)

type t = Vec3.t

(* Rounding leaves the squared length of a normalised vector within this of 1;
   normalising such a vector again would only stir its last bits. *)
let unit_tolerance = 8. *. epsilon_float

let of_vec3 (v : Vec3.t) =
  let squared = Vec3.length_squared v in
  if abs_float (squared -. 1.) <= unit_tolerance then Some v
  else if squared > 1e-280 && squared < 1e280 then
    Some (Vec3.scale (1. /. sqrt squared) v)
  else
    (* The square left the range of doubles: bring the largest component to 1
       first. Two divisions, since 1 / 4e-324 is infinite. *)
    let largest =
      Float.max (abs_float v.x) (Float.max (abs_float v.y) (abs_float v.z))
    in
    if largest > 0. && largest < infinity then
      let { Vec3.x; y; z } = v in
      let u = Vec3.make (x /. largest) (y /. largest) (z /. largest) in
      Some (Vec3.scale (1. /. Vec3.length u) u)
    else None

let of_vec3_or default v = Option.value (of_vec3 v) ~default

let of_vec3_exn v =
  match of_vec3 v with
  | Some d -> d
  | None ->
      invalid_arg
        (Format.asprintf "the vector %a has no direction: it %s" Vec3.pp v
           (if Vec3.is_finite v then "is zero" else "is not finite"))

let neg = Vec3.neg
let pp = Vec3.pp

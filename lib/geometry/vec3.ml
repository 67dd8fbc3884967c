type t = { x : float; y : float; z : float }

let[@inline] make x y z = { x; y; z }
let zero = make 0. 0. 0.
let[@inline] add u v = { x = u.x +. v.x; y = u.y +. v.y; z = u.z +. v.z }
let[@inline] sub u v = { x = u.x -. v.x; y = u.y -. v.y; z = u.z -. v.z }
let[@inline] scale k v = { x = k *. v.x; y = k *. v.y; z = k *. v.z }
let[@inline] neg v = { x = -.v.x; y = -.v.y; z = -.v.z }
let[@inline] dot u v = (u.x *. v.x) +. (u.y *. v.y) +. (u.z *. v.z)

let[@inline] cross u v =
  {
    x = (u.y *. v.z) -. (u.z *. v.y);
    y = (u.z *. v.x) -. (u.x *. v.z);
    z = (u.x *. v.y) -. (u.y *. v.x);
  }

let[@inline] length_squared v = dot v v
let[@inline] length v = sqrt (length_squared v)
let[@inline] magnitude v = abs_float v.x +. abs_float v.y +. abs_float v.z

let is_finite v =
  Float.is_finite v.x && Float.is_finite v.y && Float.is_finite v.z

let equal u v = u.x = v.x && u.y = v.y && u.z = v.z

module Infix = struct
  let ( + ) = add
  let ( - ) = sub
  let ( * ) = scale
  let ( ~- ) = neg
end

let pp ppf { x; y; z } =
  Format.fprintf ppf "(%a, %a, %a)" Number.pp x Number.pp y Number.pp z

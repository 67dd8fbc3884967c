open Raylab_geometry

type t = {
  number : int;
  t : float;
  point : Vec3.t;
  normal : Direction.t;
  offset : float;
}

let start hit =
  Vec3.add hit.point (Vec3.scale hit.offset (hit.normal :> Vec3.t))

let pp ppf hit =
  Format.fprintf ppf "t = %a at %a, normal %a" Number.pp hit.t Vec3.pp
    hit.point Direction.pp hit.normal

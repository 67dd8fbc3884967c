open Raylab_geometry

type t = {
  number : int;
  primitive : int option;
  part : int;
  t : float;
  point : Vec3.t;
  own_point : Vec3.t;
  normal : Direction.t;
  shading : Direction.t option;
  outside : bool;
  offset : float;
}

let of_registers ~primitive ~part (meeting : Meeting.t) (spot : Spot.t)
    (ray : Raw_ray.t) =
  {
    number = meeting.number + 1;
    primitive;
    part;
    t = ray.reach;
    point = Spot.point spot;
    own_point = Spot.own spot;
    normal = Spot.normal spot;
    shading = (if Spot.is_smooth spot then Some (Spot.shading spot) else None);
    outside = spot.side > 0.;
    offset = spot.offset;
  }

let start hit =
  Vec3.add hit.point (Vec3.scale hit.offset (hit.normal :> Vec3.t))

let pp_normal ppf { normal; shading; _ } =
  Direction.pp ppf normal;
  Option.iter (Format.fprintf ppf ",@ smoothed to %a" Direction.pp) shading

let pp ppf hit =
  Format.fprintf ppf "t = %a at %a, normal %a" Number.pp hit.t Vec3.pp
    hit.point pp_normal hit

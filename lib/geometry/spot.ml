type t = {
  mutable x : float;
  mutable y : float;
  mutable z : float;
  mutable nx : float;
  mutable ny : float;
  mutable nz : float;
  mutable shading_x : float;
  mutable shading_y : float;
  mutable shading_z : float;
  mutable own_x : float;
  mutable own_y : float;
  mutable own_z : float;
  mutable size : float;
  mutable side : float;
  mutable offset : float;
}

let create () =
  {
    x = 0.;
    y = 0.;
    z = 0.;
    nx = 0.;
    ny = 1.;
    nz = 0.;
    shading_x = 0.;
    shading_y = 1.;
    shading_z = 0.;
    own_x = 0.;
    own_y = 0.;
    own_z = 0.;
    size = 0.;
    side = 1.;
    offset = 0.;
  }

let[@inline] set_point spot x y z =
  spot.x <- x;
  spot.y <- y;
  spot.z <- z

let[@inline] set_own spot x y z =
  spot.own_x <- x;
  spot.own_y <- y;
  spot.own_z <- z

let[@inline] set_shading_normal spot x y z =
  spot.shading_x <- x;
  spot.shading_y <- y;
  spot.shading_z <- z

let[@inline] set_normal spot x y z =
  spot.nx <- x;
  spot.ny <- y;
  spot.nz <- z;
  set_shading_normal spot x y z

let[@inline] turn_to spot (ray : Raw_ray.t) =
  let { nx; ny; nz; _ } = spot in
  let along = (nx *. ray.dx) +. (ny *. ray.dy) +. (nz *. ray.dz) in
  let side = if along > 0. then -1. else 1. in
  let sx = side *. spot.shading_x
  and sy = side *. spot.shading_y
  and sz = side *. spot.shading_z in
  spot.side <- side;
  set_normal spot (side *. nx) (side *. ny) (side *. nz);
  if (sx *. ray.dx) +. (sy *. ray.dy) +. (sz *. ray.dz) < 0. then
    set_shading_normal spot sx sy sz

let[@inline] start spot (ray : Raw_ray.t) =
  let { x; y; z; nx; ny; nz; offset; _ } = spot in
  Raw_ray.set_origin ray
    (x +. (offset *. nx))
    (y +. (offset *. ny))
    (z +. (offset *. nz))

let[@inline] is_smooth spot =
  spot.shading_x <> spot.nx || spot.shading_y <> spot.ny
  || spot.shading_z <> spot.nz

let[@inline] start_behind spot (ray : Raw_ray.t) =
  let { x; y; z; nx; ny; nz; offset; _ } = spot in
  Raw_ray.set_origin ray
    (x -. (offset *. nx))
    (y -. (offset *. ny))
    (z -. (offset *. nz))

let[@inline] reflect spot (ray : Raw_ray.t) =
  let nx = spot.shading_x and ny = spot.shading_y and nz = spot.shading_z in
  start spot ray;
  let twice = 2. *. ((nx *. ray.dx) +. (ny *. ray.dy) +. (nz *. ray.dz)) in
  let dx = ray.dx -. (twice *. nx)
  and dy = ray.dy -. (twice *. ny)
  and dz = ray.dz -. (twice *. nz) in
  (* Rounding errors would add up along a chain of mirrors. The length is almost
     1, where (3 - s) / 2 is as good as 1 / sqrt s. *)
  let scale = 1.5 -. (0.5 *. ((dx *. dx) +. (dy *. dy) +. (dz *. dz))) in
  Raw_ray.set_direction ray (dx *. scale) (dy *. scale) (dz *. scale);
  if
    is_smooth spot
    && (spot.nx *. dx) +. (spot.ny *. dy) +. (spot.nz *. dz) < 0.
  then start_behind spot ray;
  ray.reach <- infinity

let point { x; y; z; _ } = Vec3.make x y z
let own { own_x; own_y; own_z; _ } = Vec3.make own_x own_y own_z
let normal { nx; ny; nz; _ } = Direction.of_vec3_exn (Vec3.make nx ny nz)

let shading { shading_x; shading_y; shading_z; _ } =
  Direction.of_vec3_exn (Vec3.make shading_x shading_y shading_z)

let of_point ~point:(p : Vec3.t) ~(normal : Direction.t) ~offset =
  let spot = create () and n = (normal :> Vec3.t) in
  set_point spot p.x p.y p.z;
  set_own spot p.x p.y p.z;
  set_normal spot n.x n.y n.z;
  spot.offset <- offset;
  spot

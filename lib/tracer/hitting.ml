open Raylab_geometry
open Raylab_geometry.Numbers
open Registers

(* A computed point lies within a few units in the last place (2^-52 each) of
   the largest number that went into it; this leaves some room. *)
let rounding = 0x1p-44

(* Where doubles end: no hit lies farther out, nor is moved farther off, so that
   what is computed from it is finite. *)
let farthest = 0x1p1022
let farthest_offset = rounding *. farthest

let[@inline] within x =
  if x > farthest then farthest else if x < -.farthest then -.farthest else x

(* [set_hit t x y z nx ny nz size] puts the point (x, y, z) and the normal there
   into the register, the normal on the side of the ray. [size] is the size of
   the shape, where its numbers went into the point. *)
let[@inline] set_hit t x y z nx ny nz size =
  let ray = t.ray and hit = t.hit in
  let against = (nx *. ray.dx) +. (ny *. ray.dy) +. (nz *. ray.dz) in
  let side = if against > 0. then -1. else 1. in
  hit.x <- x;
  hit.y <- y;
  hit.z <- z;
  hit.nx <- side *. nx;
  hit.ny <- side *. ny;
  hit.nz <- side *. nz;
  let least =
    rounding
    *. (size +. abs_float x +. abs_float y +. abs_float z +. abs_float ray.ox
      +. abs_float ray.oy +. abs_float ray.oz)
  and usual = t.scene.offset in
  if usual >= least then hit.offset <- usual
  else (
    hit.offset <- (if least <= farthest_offset then least else farthest_offset);
    hit.x <- within x;
    hit.y <- within y;
    hit.z <- within z)

let find t number =
  let ray = t.ray in
  let distance = ray.reach in
  let x = ray.ox +. (distance *. ray.dx)
  and y = ray.oy +. (distance *. ray.dy)
  and z = ray.oz +. (distance *. ray.dz) in
  let o = t.scene.numbers and at = Flat_scene.object_size * number in
  let radius = o.%(at + 3) in
  if radius > 0. then
    let cx = o.%(at) and cy = o.%(at + 1) and cz = o.%(at + 2) in
    let vx = x -. cx and vy = y -. cy and vz = z -. cz in
    let squared = (vx *. vx) +. (vy *. vy) +. (vz *. vz) in
    if squared > 0. && squared < infinity then
      let scale = 1. /. sqrt squared in
      let nx = vx *. scale and ny = vy *. scale and nz = vz *. scale in
      (* The sum above carries the rounding errors of origin and distance; the
         point of the sphere nearest to it only those of the sphere. *)
      set_hit t
        (cx +. (radius *. nx))
        (cy +. (radius *. ny))
        (cz +. (radius *. nz))
        nx ny nz radius
    else set_hit t x y z ray.dx ray.dy ray.dz radius
  else
    let shape = t.scene.objects.(number).shape in
    let n = (Shape.normal_raw shape x y z :> Vec3.t) in
    set_hit t x y z n.x n.y n.z 0.

let hit t number =
  let { x; y; z; nx; ny; nz; offset } = t.hit in
  {
    Hit.number = number + 1;
    t = t.ray.reach;
    point = Vec3.make x y z;
    normal = Direction.of_vec3_exn (Vec3.make nx ny nz);
    offset;
  }

let tell t number =
  match t.observe with
  | None -> ()
  | Some observe -> observe (Nearest_hit (hit t number))

open Raylab_geometry
open Raylab_geometry.Unchecked
open Raylab_expression

(* Three numbers a highlight. *)
type t = { mutable numbers : float array; mutable count : int }

let create () = { numbers = [||]; count = 0 }

let clear t (highlights : Raw_parts.t) =
  let needed = 3 * highlights.count in
  if needed > Array.length t.numbers then t.numbers <- Array.make needed 0.
  else Array.fill t.numbers 0 needed 0.;
  t.count <- highlights.count

(* (max 0 c)^s, of a cosine that rounding may have made greater than 1 *)
let[@inline] power c s =
  if c > 0. then if c < 1. then Power.pow c s else 1.
  else if s = 0. then 1.
  else 0.

let[@inline] give numbers at x =
  numbers.(at) <- Saturate.limit (numbers.%(at) +. Saturate.limit x)

(* [c] is the cosine between the mirrored ray and the way to the light. *)
let[@inline] add_each (light : Light.t) (incidence : Incidence.t) c
    (highlights : Raw_parts.t) { numbers; _ } =
  let { Color.r; g; b } = light.power in
  for k = 0 to highlights.count - 1 do
    let sharpness = highlights.numbers.%(k * highlights.size) in
    let x =
      Saturate.limit (power c sharpness *. incidence.falloff) *. incidence.cone
    in
    give numbers (3 * k) (x *. r);
    give numbers ((3 * k) + 1) (x *. g);
    give numbers ((3 * k) + 2) (x *. b)
  done

(* R . w / |w| for the way w = (x, y, z) *)
let[@inline] mirrored_cosine (spot : Spot.t) (ray : Raw_ray.t) x y z =
  let { Spot.shading_x = nx; shading_y = ny; shading_z = nz; _ } = spot
  and { Raw_ray.dx; dy; dz; _ } = ray in
  let along = (dx *. nx) +. (dy *. ny) +. (dz *. nz)
  and facing = (nx *. x) +. (ny *. y) +. (nz *. z)
  and straight = (dx *. x) +. (dy *. y) +. (dz *. z) in
  (straight -. (2. *. along *. facing))
  /. sqrt ((x *. x) +. (y *. y) +. (z *. z))

let add (light : Light.t) (incidence : Incidence.t) (spot : Spot.t) ray
    highlights t =
  match light.source with
  | Directional along ->
      let { Vec3.x; y; z } = (along :> Vec3.t) in
      let c = mirrored_cosine spot ray (-.x) (-.y) (-.z) in
      add_each light incidence c highlights t
  | Spherical _ | Spot _ | Area _ ->
      let { Incidence.x; y; z; _ } = incidence in
      let c =
        mirrored_cosine spot ray (x -. spot.x) (y -. spot.y) (z -. spot.z)
      in
      add_each light incidence c highlights t

let mean { numbers; count } n =
  let n = float_of_int n in
  for at = 0 to (3 * count) - 1 do
    numbers.(at) <- numbers.%(at) /. n
  done

let add_all t sum =
  for at = 0 to (3 * t.count) - 1 do
    give sum.numbers at t.numbers.%(at)
  done

let color { numbers; _ } k =
  Color.make numbers.(3 * k) numbers.((3 * k) + 1) numbers.((3 * k) + 2)

let colors t = List.init t.count (color t)

let add_tinted t ({ r; g; b } : Raw_color.t) sum =
  for k = 0 to t.count - 1 do
    let at = 3 * k in
    give sum.numbers at (r *. t.numbers.%(at));
    give sum.numbers (at + 1) (g *. t.numbers.%(at + 1));
    give sum.numbers (at + 2) (b *. t.numbers.%(at + 2))
  done

(* {1 Terms} *)

let[@inline] channel { numbers; _ } (highlights : Raw_parts.t) k c =
  let weight = highlights.numbers.((k * highlights.size) + 1 + c) in
  Saturate.limit (weight *. numbers.((3 * k) + c))

let[@inline] red t highlights k = channel t highlights k 0
let[@inline] green t highlights k = channel t highlights k 1
let[@inline] blue t highlights k = channel t highlights k 2

let term t highlights k =
  Color.make (red t highlights k) (green t highlights k) (blue t highlights k)

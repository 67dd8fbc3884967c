open Raylab_geometry
open Raylab_geometry.Unchecked
open Raylab_scene

type t = {
  mutable numbers : float array;
  mutable count : int;
  ray : Raw_ray.t;
  refraction : Refraction.t;
}

(* What lies where in the numbers of a bounce; its weight comes first. *)
let origin = 3
let direction = 6
let ray_share = 9
let fresnel = 10
let at_cosine = 11
let size = 12

let create () =
  {
    numbers = Array.make (8 * size) 0.;
    count = 0;
    ray = Raw_ray.create ();
    refraction = Refraction.create ();
  }

let count t = t.count
let drop_to t count = t.count <- count
let least_share = 0x1p-10

let reserve t count =
  let room = Array.length t.numbers in
  if count * size > room then
    t.numbers <-
      Array.append t.numbers
        (Array.make (Int.max room ((count * size) - room)) 0.)

(* {1 One of them} *)

let[@inline] red t k = t.numbers.%(k * size)
let[@inline] green t k = t.numbers.%((k * size) + 1)
let[@inline] blue t k = t.numbers.%((k * size) + 2)
let color t k = Color.make (red t k) (green t k) (blue t k)
let[@inline] share t k = t.numbers.%((k * size) + fresnel)
let[@inline] cosine t k = t.numbers.%((k * size) + at_cosine)
let[@inline] has_weight t k = red t k > 0. || green t k > 0. || blue t k > 0.

let[@inline] set t k r g b =
  let at = k * size in
  t.numbers.(at) <- Saturate.limit r;
  t.numbers.(at + 1) <- Saturate.limit g;
  t.numbers.(at + 2) <- Saturate.limit b

let[@inline] weigh t k (seen : Raw_color.t) =
  set t k (red t k *. seen.r) (green t k *. seen.g) (blue t k *. seen.b)

let load { numbers; _ } k (ray : Raw_ray.t) =
  let at = k * size in
  let o = at + origin and d = at + direction in
  Raw_ray.set_origin ray numbers.%(o) numbers.%(o + 1) numbers.%(o + 2);
  Raw_ray.set_direction ray numbers.%(d) numbers.%(d + 1) numbers.%(d + 2);
  ray.reach <- infinity;
  ray.share <- numbers.%(at + ray_share)

(* {1 Sending on} *)

let[@inline] store { numbers; _ } k (ray : Raw_ray.t) =
  let o = (k * size) + origin and d = (k * size) + direction in
  numbers.(o) <- ray.ox;
  numbers.(o + 1) <- ray.oy;
  numbers.(o + 2) <- ray.oz;
  numbers.(d) <- ray.dx;
  numbers.(d + 1) <- ray.dy;
  numbers.(d + 2) <- ray.dz

let add_mirror t k (lobes : Raw_lobes.t) spot (ray : Raw_ray.t) =
  let mirrored = t.ray and at = Raw_lobes.mirror in
  Raw_ray.set_direction mirrored ray.dx ray.dy ray.dz;
  Spot.reflect spot mirrored;
  store t k mirrored;
  set t k lobes.core.(at) lobes.core.(at + 1) lobes.core.(at + 2)

(* The refraction whose numbers are at [at] of [parts], as bounce [k]; what is
   mirrored of it belongs to the bounce [mirror]. *)
let add_refraction t k ~mirror parts at spot ray =
  let { refraction; numbers; _ } = t in
  Refraction.meet refraction spot ray ~index:parts.%(at);
  let f = refraction.share in
  let through = 1. -. f
  and total = if Refraction.is_total refraction then 1. else 0. in
  for channel = 0 to 2 do
    let mirror = (mirror * size) + channel and at = at + channel in
    let plain = parts.%(at + Raw_lobes.plain) in
    let mirrored =
      (f *. parts.%(at + Raw_lobes.fresnel)) +. (total *. plain)
    in
    numbers.(mirror) <- Saturate.limit (numbers.%(mirror) +. mirrored);
    numbers.((k * size) + channel) <-
      Saturate.limit
        (((1. -. total) *. plain) +. (through *. parts.%(at + Raw_lobes.glass)))
  done;
  numbers.((k * size) + fresnel) <- f;
  numbers.((k * size) + at_cosine) <- refraction.cosine;
  let { Refraction.dx; dy; dz; _ } = refraction in
  let along = (spot.nx *. dx) +. (spot.ny *. dy) +. (spot.nz *. dz) in
  (* a smooth mesh may bend it back *)
  if Spot.is_smooth spot && along > 0. then Spot.start spot t.ray
  else Spot.start_behind spot t.ray;
  Raw_ray.set_direction t.ray dx dy dz;
  store t k t.ray

let[@inline] largest t k =
  let r = red t k and g = green t k and b = blue t k in
  let most = if r > g then r else g in
  if b > most then b else most

let share_out t first (ray : Raw_ray.t) =
  let sum = ref 0. and weighty = ref 0 in
  for k = first to t.count - 1 do
    let weight = largest t k in
    sum := !sum +. weight;
    if weight > 0. then incr weighty
  done;
  let whole = if !sum > 1. then Saturate.limit !sum else 1. in
  for k = first to t.count - 1 do
    t.numbers.((k * size) + ray_share) <-
      (if !weighty > 1 then ray.share *. (largest t k /. whole) else ray.share)
  done

let add t (lobes : Raw_lobes.t) spot ray =
  let { Raw_parts.numbers = parts; size; count } = lobes.refractions in
  let mirror = t.count in
  reserve t (mirror + 1 + count);
  t.count <- mirror + 1 + count;
  add_mirror t mirror lobes spot ray;
  for part = 0 to count - 1 do
    add_refraction t (mirror + 1 + part) ~mirror parts (part * size) spot ray
  done;
  share_out t mirror ray

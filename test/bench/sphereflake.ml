(* Prints the scene of a sphereflake: a ball that carries nine balls of a third
   its radius, each of which carries nine ... With four levels under the first
   ball these are 1 + 9 + 81 + 729 + 6561 = 7,381 spheres, Eric Haines'
   "balls" of the Standard Procedural Databases.

     ocaml sphereflake.ml [LEVELS] > sphereflake.scene

   It needs nothing but the standard library. *)

type vec = { x : float; y : float; z : float }

let vec x y z = { x; y; z }
let ( + ) a b = vec (a.x +. b.x) (a.y +. b.y) (a.z +. b.z)
let ( * ) k a = vec (k *. a.x) (k *. a.y) (k *. a.z)
let dot a b = (a.x *. b.x) +. (a.y *. b.y) +. (a.z *. b.z)

let cross a b =
  vec
    ((a.y *. b.z) -. (a.z *. b.y))
    ((a.z *. b.x) -. (a.x *. b.z))
    ((a.x *. b.y) -. (a.y *. b.x))

let normalize a = 1. /. sqrt (dot a a) * a
let radians degrees = degrees *. Float.pi /. 180.

(* A frame: three perpendicular unit vectors, of which [up] leads away from the
   parent ball. *)
type frame = { right : vec; up : vec; ahead : vec }

(* The direction at an elevation above the equator of a frame. *)
let direction frame ~azimuth ~elevation =
  (cos elevation *. cos azimuth * frame.right)
  + (cos elevation *. sin azimuth * frame.ahead)
  + (sin elevation * frame.up)

(* Where the nine children sit: six on the equator, and three above, over
   every other gap, as oranges are packed: each of the nine is 60 degrees away
   from its neighbours. *)
let children frame =
  let at elevation azimuth =
    let up = direction frame ~azimuth ~elevation in
    (* The child's frame: [ahead] runs along the parent's parallel. *)
    let ahead =
      normalize
        (direction frame ~azimuth:(azimuth +. radians 90.) ~elevation:0.)
    in
    { right = cross ahead up; up; ahead }
  in
  List.map (fun k -> at 0. (radians (60. *. k))) [ 0.; 1.; 2.; 3.; 4.; 5. ]
  @ List.map
      (fun k -> at (acos (1. /. sqrt 3.)) (radians (30. +. (120. *. k))))
      [ 0.; 1.; 2. ]

(* Six significant digits for a place and five for a radius: far finer than a
   pixel. *)
let sphere ~level centre radius =
  Printf.printf "sphere %.6g %.6g %.6g %.5g\n %s\n" centre.x centre.y centre.z
    radius
    (if level = 0 then "mixed 0.45 diffusive 1 0.9 0.7  0.55 reflective"
     else "mixed 0.7 diffusive 1 0.9 0.7  0.3 reflective")

let rec flake ~levels ~level frame centre radius =
  sphere ~level centre radius;
  if level < levels then
    let radius' = radius /. 3. in
    List.iter
      (fun child ->
        let centre' = centre + ((radius +. radius') * child.up) in
        flake ~levels ~level:(succ level) child centre' radius')
      (children frame)

let rec power b n = if n = 0 then 1 else Int.mul b (power b (n - 1))

(* The eye of a scene cannot be turned, so the world is: the ground leans
   towards the eye, and the flake stands upright on it. *)
let pitch = radians 11.
let up = vec 0. (cos pitch) (-.sin pitch)

let frame =
  let turn = radians 13. in
  let right = vec 1. 0. 0. and ahead = vec 0. (sin pitch) (cos pitch) in
  {
    up;
    right = (cos turn * right) + (sin turn * ahead);
    ahead = (-.sin turn * right) + (cos turn * ahead);
  }

let () =
  let levels = match Sys.argv with [| _; n |] -> int_of_string n | _ -> 4 in
  let count = (power 9 (succ levels) - 1) / 8 in
  let centre = vec 0. (-0.25) 6. and radius = 1.5 in
  let ground = centre + (-.radius * up) in
  Printf.printf
    {|# Sphereflake: %d balls, each carrying nine of a third its radius.

# A classic of ray tracing: "balls", from Eric Haines' Standard Procedural
# Databases. The balls are not written by hand: a small program counts them
# out, test/bench/sphereflake.ml.

imWidth 800
imHeight 640
canvWidth 4
canvHeight 3.2
depth 7.5
bcolor 0.08 0.3 0.62
raydepth 6

lights
# The sun, from the upper left, behind us ...
directional 1.1 1 0.97 0.9   1 -1.2 1
# ... the sky from the right, and a little light from where we stand.
directional 0.3 0.75 0.85 1   -1.5 -1 0.8
directional 0.2 white   0.1 -0.3 1

objects
# The ground leans towards the eye, which itself cannot look down.
plane %.6g %.6g %.6g   %.6g %.6g %.6g   diffusive 0.9 0.6 0.24

|}
    count ground.x ground.y ground.z up.x up.y up.z;
  flake ~levels ~level:0 frame centre radius

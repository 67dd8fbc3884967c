type t = { centre : Vec3.t; axis : Direction.t; ring : float; tube : float }

let make ~(centre : Vec3.t) ~axis ~ring ~tube =
  Number.require Finite "the x of the centre" centre.x;
  Number.require Finite "the y of the centre" centre.y;
  Number.require Finite "the z of the centre" centre.z;
  Number.require Positive "the radius of the ring" ring;
  Number.require Positive "the radius of the tube" tube;
  if tube > ring then
    invalid_arg
      (Printf.sprintf
         "the radius of the tube, %g, is greater than that of the ring, %g"
         tube ring);
  { centre; axis; ring; tube }

let name = "torus"

let parameters { centre; axis; ring; tube } =
  [
    ("centre", Parameter.of_vec3 centre);
    ("axis", Parameter.of_vec3 (axis :> Vec3.t));
    ("ring", Parameter.Number ring);
    ("tube", Parameter.Number tube);
  ]

(* That of the circle in the tube's middle, widened by a ball. *)
let box { centre; axis; ring; tube } =
  let { Box3.low; high } = Round.box [ (centre, ring) ] axis in
  let more = Vec3.make tube tube tube in
  Box3.around [ Vec3.sub low more; Vec3.add high more ]

(* {1 Enclosed roots} *)

(* Roots are numbers of the size of 1 at most. *)
let precision = 4. *. epsilon_float

(* [next x newton low high last] is where to look after [x], with the root
   between [low] and [high]: at [newton] if that gets on, else half way. *)
let[@inline] next x newton low high last =
  if
    newton >= low && newton <= high
    && abs_float (newton -. x) < 0.5 *. abs_float last
  then newton
  else 0.5 *. (low +. high)

(* Of 4 s^3 + 2 p s + q, between two places where it only rises or only falls;
   where it has none there, one of the places. *)
let[@inline] root_of_cubic p q low high =
  let low = ref low and high = ref high in
  let is_positive = (((4. *. !low *. !low) +. (2. *. p)) *. !low) +. q > 0. in
  if
    !low >= !high
    || (((4. *. !high *. !high) +. (2. *. p)) *. !high) +. q > 0. = is_positive
  then !low
  else
    let x = ref (0.5 *. (!low +. !high)) and last = ref infinity in
    while abs_float !last > precision do
      let f = (((4. *. !x *. !x) +. (2. *. p)) *. !x) +. q in
      if f > 0. = is_positive then low := !x else high := !x;
      let newton = !x -. (f /. ((12. *. !x *. !x) +. (2. *. p))) in
      let x' = next !x newton !low !high !last in
      last := x' -. !x;
      x := x'
    done;
    !x

(* [a], the square of the way from the axis being [across]. *)
let[@inline] value ring tube across y =
  let q = sqrt (if across > 0. then across else 0.) -. ring in
  ((q -. tube) *. (q +. tube)) +. (y *. y)

(* Of [a], between two places that it has different signs at; [is_inside] is
   whether it is negative at the first. *)
let[@inline] root_of_torus ring tube squared y0 rise low high is_inside =
  let low = ref low and high = ref high in
  let x = ref (0.5 *. (!low +. !high)) and last = ref infinity in
  while abs_float !last > precision do
    let y = y0 +. (!x *. rise) in
    let across = squared +. (!x *. !x) -. (y *. y) in
    let f = value ring tube across y in
    if f < 0. = is_inside then low := !x else high := !x;
    let q = sqrt (if across > 0. then across else 0.) in
    let slope =
      2. *. (((q -. ring) *. (!x -. (y *. rise)) /. q) +. (y *. rise))
    in
    let x' = next !x (!x -. (f /. slope)) !low !high !last in
    last := x' -. !x;
    x := x'
  done;
  !x

(* {1 What is hit} *)

let[@inline] dot x y z x' y' z' = (x *. x') +. (y *. y') +. (z *. z')

(* With [middle] where the line is nearest to the centre, all else as parts of
   [unit]; the line is within the ball around the torus up to [reach] from
   there. *)
let[@inline] solve crossings ring tube squared y0 rise middle unit reach =
  let k = squared +. (ring *. ring) -. (tube *. tube) in
  let around = 4. *. ring *. ring in
  let p = (2. *. k) -. (around *. (1. -. (rise *. rise)))
  and q = 2. *. around *. y0 *. rise in
  let bend = if p < 0. then sqrt (p /. -6.) else 0. in
  let bend = if bend < reach then bend else reach in
  let low = ref (-.reach) and was_inside = ref false in
  for piece = 0 to 3 do
    let high =
      if piece = 3 then reach
      else
        let from =
          if piece = 0 then -.reach else if piece = 1 then -.bend else bend
        and upto =
          if piece = 0 then -.bend else if piece = 1 then bend else reach
        in
        root_of_cubic p q from upto
    in
    let y = y0 +. (high *. rise) in
    let is_inside =
      piece < 3
      && value ring tube (squared +. (high *. high) -. (y *. y)) y < 0.
    in
    if is_inside <> !was_inside then
      Crossings.add crossings ~part:0
        (middle
        +. unit
           *. root_of_torus ring tube squared y0 rise !low high !was_inside);
    low := high;
    was_inside := is_inside
  done

let crossings { centre = c; axis; ring; tube } (ray : Raw_ray.t) crossings =
  let { Raw_ray.ox; oy; oz; dx; dy; dz; _ } = ray in
  let w = (axis :> Vec3.t) in
  Crossings.clear crossings ~starts_inside:false;
  let middle = dot (c.x -. ox) (c.y -. oy) (c.z -. oz) dx dy dz in
  let unit = ring +. tube in
  let x = (ox +. (middle *. dx) -. c.x) /. unit
  and y = (oy +. (middle *. dy) -. c.y) /. unit
  and z = (oz +. (middle *. dz) -. c.z) /. unit in
  let squared = dot x y z x y z in
  (* false for NaN *)
  if squared < 1. && abs_float middle < infinity then
    let y0 = dot x y z w.x w.y w.z and rise = dot dx dy dz w.x w.y w.z in
    solve crossings (ring /. unit) (tube /. unit) squared y0 rise middle unit
      (sqrt (1. -. squared))

let offer torus ray (meeting : Meeting.t) ~number =
  crossings torus ray meeting.room;
  Meeting.offer_room meeting ray ~number

(* From the nearest point of the circle in the middle of the tube. At its own
   centre, or on the axis, where all are as near, any of them is. *)
let settle { centre = c; axis; ring; tube } ray (spot : Spot.t) =
  let w = (axis :> Vec3.t) in
  let px = Raw_ray.end_x ray -. c.x
  and py = Raw_ray.end_y ray -. c.y
  and pz = Raw_ray.end_z ray -. c.z in
  let height = dot px py pz w.x w.y w.z in
  let qx = px -. (height *. w.x)
  and qy = py -. (height *. w.y)
  and qz = pz -. (height *. w.z) in
  let far = sqrt (dot qx qy qz qx qy qz) in
  let scale = if far > 0. && far < infinity then ring /. far else 0. in
  let mx = scale *. qx and my = scale *. qy and mz = scale *. qz in
  let vx = px -. mx and vy = py -. my and vz = pz -. mz in
  let squared = dot vx vy vz vx vy vz in
  (if squared > 0. && squared < infinity then (
     let inverse = 1. /. sqrt squared in
     let nx = inverse *. vx and ny = inverse *. vy and nz = inverse *. vz in
     let x = c.x +. mx +. (tube *. nx)
     and y = c.y +. my +. (tube *. ny)
     and z = c.z +. mz +. (tube *. nz) in
     Spot.set_normal spot nx ny nz;
     Spot.set_point spot x y z;
     Spot.set_own spot x y z)
   else
     let x = Raw_ray.end_x ray
     and y = Raw_ray.end_y ray
     and z = Raw_ray.end_z ray in
     Spot.set_normal spot w.x w.y w.z;
     Spot.set_point spot x y z;
     Spot.set_own spot x y z);
  spot.size <- ring +. tube

let depth { centre; axis; ring; tube } point =
  let w = (axis :> Vec3.t) in
  let p = Vec3.sub point centre in
  let height = Vec3.dot p w in
  let q = Vec3.length (Vec3.sub p (Vec3.scale height w)) -. ring in
  tube -. sqrt ((q *. q) +. (height *. height))

(* {1 What is told} *)

(* Around each of 24 places of the ring a circle of the tube; between two of
   them lies a piece. *)
let pieces { centre; axis; ring; tube } =
  let w = (axis :> Vec3.t) in
  let slice middle =
    let along = Vec3.cross w (Vec3.sub middle centre) in
    Round.rim (Direction.of_vec3_or axis along) (middle, tube)
  in
  let slices = List.map slice (Round.rim axis (centre, ring)) in
  match slices with
  | [] -> []
  | first :: rest -> List.map2 ( @ ) slices (rest @ [ first ])

let pp ppf { centre; axis; ring; tube } =
  Format.fprintf ppf "torus centre %a axis %a ring %a tube %a" Vec3.pp centre
    Direction.pp axis Number.pp ring Number.pp tube

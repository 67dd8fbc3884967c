type t = {
  a : Vec3.t;
  b : Vec3.t;
  radius_a : float;
  radius_b : float;
  axis : Direction.t;
  length : float;
  slope : float;
  across : float;
  along : float;
}

let make a radius_a b radius_b =
  let require point { Vec3.x; y; z } =
    Number.require Finite ("the x of point " ^ point) x;
    Number.require Finite ("the y of point " ^ point) y;
    Number.require Finite ("the z of point " ^ point) z
  in
  require "A" a;
  require "B" b;
  Number.require Non_negative "the radius at A" radius_a;
  Number.require Non_negative "the radius at B" radius_b;
  if radius_a = 0. && radius_b = 0. then invalid_arg "both radii are 0";
  let way = Vec3.sub b a in
  match Direction.of_vec3 way with
  | None -> invalid_arg "both ends are at one point, or too far apart"
  | Some axis ->
      let length = Vec3.dot way (axis :> Vec3.t) in
      let growth = radius_b -. radius_a in
      let normal = Direction.of_vec3_exn (Vec3.make length (-.growth) 0.) in
      let { Vec3.x = across; y = along; _ } = (normal :> Vec3.t) in
      {
        a;
        b;
        radius_a;
        radius_b;
        axis;
        length;
        slope = growth /. length;
        across;
        along;
      }

let circles { a; b; radius_a; radius_b; _ } = [ (a, radius_a); (b, radius_b) ]
let box frustum = Round.box (circles frustum) frustum.axis

(* {1 What is hit} *)

let[@inline] dot x y z x' y' z' = (x *. x') +. (y *. y') +. (z *. z')

(* Tells of the piece of the line from [enters] to [leaves], at the end and the
   wall, whichever is later or sooner. All comparisons are false for NaN. *)
let[@inline] tell crossings middle dy wall_in wall_out ends_in ends_out =
  if
    wall_in <= wall_out && ends_in <= ends_out && wall_in <= ends_out
    && ends_in <= wall_out
  then
    let enters = if ends_in > wall_in then ends_in else wall_in
    and leaves = if ends_out < wall_out then ends_out else wall_out in
    if enters > neg_infinity && leaves < infinity then (
      let first = if dy < 0. then 2 else 1 in
      Crossings.add crossings
        ~part:(if ends_in > wall_in then first else 0)
        (middle +. enters);
      Crossings.add crossings
        ~part:(if ends_out < wall_out then 3 - first else 0)
        (middle +. leaves))

(* What is negative is so by rounding only, where it is asked for. *)
let[@inline] root_of x = if x <= 0. then 0. else sqrt x

let crossings { a; b; radius_a; axis; length; slope; _ } (ray : Raw_ray.t)
    crossings =
  let { Raw_ray.ox; oy; oz; dx; dy; dz; _ } = ray in
  let w = (axis :> Vec3.t) in
  Crossings.clear crossings ~starts_inside:false;
  let middle =
    dot
      ((0.5 *. a.x) +. (0.5 *. b.x) -. ox)
      ((0.5 *. a.y) +. (0.5 *. b.y) -. oy)
      ((0.5 *. a.z) +. (0.5 *. b.z) -. oz)
      dx dy dz
  in
  let px = ox +. (middle *. dx) -. a.x
  and py = oy +. (middle *. dy) -. a.y
  and pz = oz +. (middle *. dz) -. a.z in
  let height = dot px py pz w.x w.y w.z and rise = dot dx dy dz w.x w.y w.z in
  let qx = px -. (height *. w.x)
  and qy = py -. (height *. w.y)
  and qz = pz -. (height *. w.z)
  and ex = dx -. (rise *. w.x)
  and ey = dy -. (rise *. w.y)
  and ez = dz -. (rise *. w.z) in
  let g = radius_a +. (slope *. height) and h = slope *. rise in
  let sx = (g *. ex) -. (h *. qx)
  and sy = (g *. ey) -. (h *. qy)
  and sz = (g *. ez) -. (h *. qz)
  and cx = (qy *. ez) -. (qz *. ey)
  and cy = (qz *. ex) -. (qx *. ez)
  and cz = (qx *. ey) -. (qy *. ex) in
  let discriminant = dot sx sy sz sx sy sz -. dot cx cy cz cx cy cz in
  let steepness = (h *. h) -. dot ex ey ez ex ey ez in
  let squared = dot qx qy qz qx qy qz and limit = g *. g in
  if squared +. limit < infinity && (discriminant >= 0. || steepness >= 0.)
  then
    let half = root_of discriminant in
    let b = dot qx qy qz ex ey ez -. (h *. g) and c = squared -. limit in
    let q = if b >= 0. then -.b -. half else half -. b in
    (* of a line as steep as the wall the other root is infinitely far on the
       other side of the tip *)
    let root = -.(q /. steepness) in
    let root' = if q = 0. then root else c /. q in
    let less = if root < root' then root else root'
    and more = if root < root' then root' else root in
    let is_along = rise = 0. in
    let down = -.height /. rise and up = (length -. height) /. rise in
    let ends_in =
      if is_along then
        if height >= 0. && height <= length then neg_infinity else nan
      else if rise > 0. then down
      else up
    and ends_out =
      if is_along then infinity else if rise > 0. then up else down
    in
    if steepness < 0. then
      tell crossings middle rise less more ends_in ends_out
    else if h > 0. then
      tell crossings middle rise more infinity ends_in ends_out
    else if h < 0. then
      tell crossings middle rise neg_infinity less ends_in ends_out
    else if c <= 0. then
      tell crossings middle rise neg_infinity infinity ends_in ends_out

let offer frustum ray (meeting : Meeting.t) ~number =
  crossings frustum ray meeting.room;
  Meeting.offer_room meeting ray ~number

let settle_on_wall { a; radius_a; axis; length; slope; across; along; _ } ray
    (spot : Spot.t) =
  let w = (axis :> Vec3.t) in
  let px = Raw_ray.end_x ray -. a.x
  and py = Raw_ray.end_y ray -. a.y
  and pz = Raw_ray.end_z ray -. a.z in
  let height = dot px py pz w.x w.y w.z in
  let qx = px -. (height *. w.x)
  and qy = py -. (height *. w.y)
  and qz = pz -. (height *. w.z) in
  let height =
    if height < 0. then 0. else if height > length then length else height
  in
  let squared = dot qx qy qz qx qy qz in
  if squared > 0. && squared < infinity then (
    let scale = 1. /. sqrt squared in
    let qx = scale *. qx and qy = scale *. qy and qz = scale *. qz in
    let radius = radius_a +. (slope *. height) in
    let x = a.x +. (height *. w.x) +. (radius *. qx)
    and y = a.y +. (height *. w.y) +. (radius *. qy)
    and z = a.z +. (height *. w.z) +. (radius *. qz) in
    Spot.set_normal spot
      ((across *. qx) +. (along *. w.x))
      ((across *. qy) +. (along *. w.y))
      ((across *. qz) +. (along *. w.z));
    Spot.set_point spot x y z;
    Spot.set_own spot x y z)
  else
    (* at the tip *)
    let out = if slope < 0. then 1. else -1. in
    let x = a.x +. (height *. w.x)
    and y = a.y +. (height *. w.y)
    and z = a.z +. (height *. w.z) in
    Spot.set_normal spot (out *. w.x) (out *. w.y) (out *. w.z);
    Spot.set_point spot x y z;
    Spot.set_own spot x y z

let settle frustum ~part ray (spot : Spot.t) =
  let { a; b; radius_a; radius_b; axis; length; _ } = frustum in
  (match part with
  | 0 -> settle_on_wall frustum ray spot
  | 1 -> Flat.settle a (Direction.neg axis) ray spot
  | _ -> Flat.settle b axis ray spot);
  let radius = if radius_a > radius_b then radius_a else radius_b in
  spot.size <- (if length > radius then length else radius)

(* To the nearest of the two ends and the wall. *)
let depth { a; radius_a; axis; length; slope; across; _ } point =
  let w = (axis :> Vec3.t) in
  let p = Vec3.sub point a in
  let height = Vec3.dot p w in
  let q = Vec3.length (Vec3.sub p (Vec3.scale height w)) in
  let from_wall = across *. (radius_a +. (slope *. height) -. q) in
  Float.min from_wall (Float.min height (length -. height))

(* {1 What is told} *)

let part = function
  | 0 -> None
  | 1 -> Some "first end"
  | _ -> Some "second end"

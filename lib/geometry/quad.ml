type t = {
  corner : Vec3.t;
  edge : Vec3.t;
  other : Vec3.t;
  end_of_edge : Vec3.t;
  far : Vec3.t;
  end_of_other : Vec3.t;
  normal : Direction.t;
  span : float;
}

let make ~corner ~edge ~other =
  let end_of_edge = Vec3.add corner edge in
  let far = Vec3.add end_of_edge other
  and end_of_other = Vec3.add corner other in
  let require { Vec3.x; y; z } =
    Number.require Finite "the x of a corner" x;
    Number.require Finite "the y of a corner" y;
    Number.require Finite "the z of a corner" z
  in
  List.iter require [ corner; end_of_edge; far; end_of_other ];
  match Flat.normal edge other with
  | Some normal ->
      let span = Flat.span edge other in
      { corner; edge; other; end_of_edge; far; end_of_other; normal; span }
  | None -> invalid_arg "the edges of a quad are parallel"

let name = "quad"

let parameters { corner; edge; other; _ } =
  [
    ("corner", Parameter.of_vec3 corner);
    ("edge", Parameter.of_vec3 edge);
    ("other", Parameter.of_vec3 other);
  ]

let corners { corner; end_of_edge; far; end_of_other; _ } =
  [ corner; end_of_edge; far; end_of_other ]

(* NaN if the line passes outside. *)
let[@inline] distance quad (ray : Raw_ray.t) =
  let {
    corner = a;
    end_of_edge = b;
    far = c;
    end_of_other = d;
    normal;
    span;
    _;
  } =
    quad
  in
  let ab = Flat.side ray a.x a.y a.z b.x b.y b.z
  and bc = Flat.side ray b.x b.y b.z c.x c.y c.z
  and cd = Flat.side ray c.x c.y c.z d.x d.y d.z
  and da = Flat.side ray d.x d.y d.z a.x a.y a.z in
  if
    (ab >= 0. && bc >= 0. && cd >= 0. && da >= 0.)
    || (ab <= 0. && bc <= 0. && cd <= 0. && da <= 0.)
  then Flat.distance_near a normal span ray
  else nan

let offer quad ray meeting ~number =
  Meeting.offer meeting ray ~number ~part:0 (distance quad ray)

let settle { corner; normal; _ } ray spot = Flat.settle corner normal ray spot
let crossings quad ray crossings = Flat.cross (distance quad ray) crossings

let pp ppf { corner; edge; other; _ } =
  Format.fprintf ppf "quad corner %a edges %a and %a" Vec3.pp corner Vec3.pp
    edge Vec3.pp other

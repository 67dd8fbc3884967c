(* The equations of doc/semantics.mld, written from that page alone: of the
   libraries they take data and the arithmetic of vectors and colours, and no
   function that the tracer computes with. *)

open Raylab_geometry
open Raylab_expression
open Raylab_scene
open Raylab_tracer
open Test_support

(* + - * are of vectors, +. -. *. of numbers *)
open Vec3.Infix

let dot = Vec3.dot
let length v = sqrt (dot v v)
let unit v = 1. /. length v * v
let ( ++ ) = Color.add

(* {1 Rays} *)

type ray = { o : Vec3.t; d : Vec3.t; rho : float; seed : float }

let at { o; d; _ } t = o + (t * d)
let mirrored d n = d - (2. *. dot d n * n)

(* {1 Shapes} *)

let centre (s : Sphere.t) = Vec3.make s.cx s.cy s.cz

(* v turned by -angle, u the axis *)
let unturned u angle v =
  let radians = -.angle *. Float.pi /. 180. in
  let c = cos radians and s = sin radians in
  (c * v) + (s * Vec3.cross u v) + (dot u v *. (1. -. c) * u)

let each f { Vec3.x; y; z } (k : Vec3.t) =
  Vec3.make (f x k.x) (f y k.y) (f z k.z)

(* The linear part of the inverse, and the inverse. *)
let undo_vector v : Change.modifier -> Vec3.t = function
  | Scaled k -> 1. /. k * v
  | Stretched k -> each ( /. ) v k
  | Rotated { axis; angle; _ } -> unturned (axis :> Vec3.t) angle v
  | Translated _ -> v

let undo_point p : Change.modifier -> Vec3.t = function
  | Translated way -> p - way
  | modifier -> undo_vector p modifier

let undone undo modifiers v = List.fold_left undo v (List.rev modifiers)

(* The height along an axis from a point, and the way from the axis. *)
let from_axis a (axis : Direction.t) p =
  let w = (axis :> Vec3.t) in
  let y = dot (p - a) w in
  (y, p - a - (y * w))

let axes =
  [
    (fun { Vec3.x; _ } -> x);
    (fun { Vec3.y; _ } -> y);
    (fun { Vec3.z; _ } -> z);
  ]

let rec is_within low high p = function
  | [] -> true
  | of_axis :: rest ->
      of_axis low <= of_axis p
      && of_axis p <= of_axis high
      && is_within low high p rest

(* Each face, with its coordinate and outward normal. *)
let faces { Box.low; high } =
  List.concat_map
    (fun axis ->
      let unit sign =
        let along k = if List.nth axes k == axis then sign else 0. in
        Vec3.make (along 0) (along 1) (along 2)
      in
      [ (axis, axis low, unit (-1.)); (axis, axis high, unit 1.) ])
    axes

let box_intersections ({ Box.low; high } as box) ({ o; d; _ } as ray) =
  List.filter_map
    (fun (axis, value, _) ->
      let t = (value -. axis o) /. axis d in
      let others = List.filter (fun other -> other != axis) axes in
      if is_within low high (at ray t) others then Some t else None)
    (faces box)

let roots a b c =
  let delta = (b *. b) -. (a *. c) in
  if delta < 0. then []
  else [ (-.b -. sqrt delta) /. a; (-.b +. sqrt delta) /. a ]

let frustum_intersections (f : Frustum.t) ({ o; d; _ } as ray) =
  let w = (f.axis :> Vec3.t) in
  let y, q = from_axis f.a f.axis o in
  let e = d - (dot d w * w) and h = f.slope *. dot d w in
  let g = f.radius_a +. (f.slope *. y) in
  let wall =
    roots (dot e e -. (h *. h)) (dot q e -. (g *. h)) (dot q q -. (g *. g))
  and is_on_wall t =
    let y, _ = from_axis f.a f.axis (at ray t) in
    0. <= y && y <= f.length
  and ends =
    [ (0., f.radius_a); (f.length, f.radius_b) ]
    |> List.filter_map (fun (height, radius) ->
           let t = (height -. y) /. dot d w in
           let _, q = from_axis f.a f.axis (at ray t) in
           if length q <= radius then Some t else None)
  in
  List.filter is_on_wall wall @ ends

(* All roots of a polynomial that begins with x^4, at once (E. Durand, 1960;
   I. Kerner, 1966): not the way of the tracer. *)
let quartic_roots c3 c2 c1 c0 =
  let open Complex in
  let real x = { re = x; im = 0. } in
  let value x =
    List.fold_left
      (fun sum c -> add (mul sum x) (real c))
      one [ c3; c2; c1; c0 ]
  in
  let better roots =
    List.mapi
      (fun k x ->
        let others = List.filteri (fun l _ -> l <> k) roots in
        let product = List.fold_left (fun p y -> mul p (sub x y)) one others in
        sub x (div (value x) product))
      roots
  in
  let start = List.map (fun k -> pow { re = 0.4; im = 0.9 } (real k)) in
  Seq.iterate better (start [ 0.; 1.; 2.; 3. ])
  |> Seq.drop 100 |> Seq.uncons |> Option.get |> fst
  |> List.filter_map (fun { re; im } ->
         if abs_float im < 1e-5 then Some re else None)

let torus_intersections { Torus.centre; axis; ring; tube } { o; d; _ } =
  let w = (axis :> Vec3.t) and size = length d in
  let d = unit d in
  let m = dot (centre - o) d in
  let v = o + (m * d) - centre in
  let y = dot v w and k = dot v v +. (ring *. ring) -. (tube *. tube) in
  let r = 4. *. ring *. ring and rise = dot d w in
  quartic_roots 0.
    ((2. *. k) -. (r *. (1. -. (rise *. rise))))
    (2. *. r *. y *. rise)
    ((k *. k) -. (r *. (dot v v -. (y *. y))))
  |> List.map (fun s -> (m +. s) /. size)

let plane_intersections q (normal : Direction.t) { o; d; _ } =
  let n = (normal :> Vec3.t) in
  if dot d n <> 0. then [ dot (q - o) n /. dot d n ] else []

(* The numbers u and v with p = corner + u e1 + v e2. *)
let in_plane corner e1 e2 p =
  let n = Vec3.cross e1 e2 and p = p - corner in
  (dot (Vec3.cross p e2) n /. dot n n, dot (Vec3.cross e1 p) n /. dot n n)

(* The three of each triangle, from one array by another. *)
let triples (numbers : float array) (indexes : int array) =
  let vector k =
    let at axis = numbers.(Int.add (Int.mul 3 k) axis) in
    Vec3.make (at 0) (at 1) (at 2)
  in
  List.init
    (Array.length indexes / 3)
    (fun t ->
      let corner k = vector indexes.(Int.add (Int.mul 3 t) k) in
      (corner 0, corner 1, corner 2))

let triangles mesh =
  let { Facets.points; corners; _ } = Mesh.facets mesh in
  triples points corners

let wound (a, b, c) = unit (Vec3.cross (b - a) (c - a))

let triangle_intersections (normal : Direction.t) (a, b, c) ray =
  let is_in t =
    let u, v = in_plane a (b - a) (c - a) (at ray t) in
    u >= 0. && v >= 0. && u +. v <= 1.
  in
  List.filter is_in (plane_intersections a normal ray)

(* A line through an edge meets one of the triangles beside it. *)
let rec once_an_edge = function
  | t :: t' :: rest when t' -. t < 1e-9 -> once_an_edge (t :: rest)
  | t :: rest -> t :: once_an_edge rest
  | [] -> []

let rec intersections (shape : Shape.t) ray =
  let { o; d; _ } = ray in
  match shape with
  | Sphere s ->
      (* of a ray whose direction may have any length *)
      let dd = dot d d in
      let m = dot (centre s - o) d /. dd in
      let l = centre s - o - (m * d) in
      let delta = (s.radius *. s.radius) -. dot l l in
      let half = sqrt (delta /. dd) in
      if delta >= 0. then [ m -. half; m +. half ] else []
  | Plane { point; normal } -> plane_intersections point normal ray
  | Box b -> box_intersections b ray
  | Cylinder c -> frustum_intersections (c :> Frustum.t) ray
  | Cone c -> frustum_intersections (c :> Frustum.t) ray
  | Torus t -> torus_intersections t ray
  | Disc { centre; normal; radius } ->
      let is_in t = length (at ray t - centre) < radius in
      List.filter is_in (plane_intersections centre normal ray)
  | Triangle { a; b; c; normal; _ } ->
      triangle_intersections normal (a, b, c) ray
  | Mesh mesh ->
      triangles mesh
      |> List.concat_map (fun corners ->
             let normal = Direction.of_vec3_exn (wound corners) in
             triangle_intersections normal corners ray)
      |> List.sort Float.compare |> once_an_edge
  | Quad { corner; edge; other; normal; _ } ->
      let is_in t =
        let u, v = in_plane corner edge other (at ray t) in
        u >= 0. && v >= 0. && u <= 1. && v <= 1.
      in
      List.filter is_in (plane_intersections corner normal ray)
  | Placed { own; modifiers; _ } ->
      let o = undone undo_point modifiers o
      and d = undone undo_vector modifiers d in
      intersections own { ray with o; d }
  | Solid _ -> assert false (* see Solids *)

(* Of faces, each with how far away it is, the nearest one's normal. *)
let of_nearest faces =
  let nearer (a, _) (b, _) = Float.compare (abs_float a) (abs_float b) in
  snd (List.hd (List.sort nearer faces))

let frustum_outward (f : Frustum.t) p =
  let w = (f.axis :> Vec3.t) in
  let y, q = from_axis f.a f.axis p in
  let wall = unit (unit q - (f.slope * w)) in
  of_nearest
    [
      (length q -. f.radius_a -. (f.slope *. y), wall);
      (y, -w);
      (f.length -. y, w);
    ]

(* How far p is from a triangle's plane, or from the triangle by u and v. *)
let from_triangle p (a, b, c) =
  let u, v = in_plane a (b - a) (c - a) p in
  let beside = List.fold_left Float.min 0. [ u; v; 1. -. u -. v ] in
  Float.max (abs_float (dot (p - a) (wound (a, b, c)))) (-.beside)

(* The normals at the corners, each times its weight. *)
let blended p ((a, b, c), (na, nb, nc)) =
  let u, v = in_plane a (b - a) (c - a) p in
  unit (((1. -. u -. v) * na) + (u * nb) + (v * nc))

(* M^-T is made of the columns of M^-1. *)
let placed_normal modifiers n =
  let part x y z = dot (undone undo_vector modifiers (Vec3.make x y z)) n in
  unit (Vec3.make (part 1. 0. 0.) (part 0. 1. 0.) (part 0. 0. 1.))

let rec outward (shape : Shape.t) p =
  match shape with
  | Mesh mesh ->
      triangles mesh
      |> List.map (fun corners -> (from_triangle p corners, wound corners))
      |> of_nearest
  | Sphere s -> 1. /. s.radius * (p - centre s)
  | Plane { normal; _ } | Disc { normal; _ } -> (normal :> Vec3.t)
  | Triangle { a; b; c; _ } -> unit (Vec3.cross (b - a) (c - a))
  | Quad { edge; other; _ } -> unit (Vec3.cross edge other)
  | Box b ->
      faces b
      |> List.map (fun (axis, value, normal) -> (axis p -. value, normal))
      |> of_nearest
  | Cylinder c -> frustum_outward (c :> Frustum.t) p
  | Cone c -> frustum_outward (c :> Frustum.t) p
  | Torus { centre; axis; ring; _ } ->
      let _, q = from_axis centre axis p in
      unit (p - centre - (ring * unit q))
  | Placed { own; modifiers; _ } ->
      placed_normal modifiers (outward own (undone undo_point modifiers p))
  | Solid _ -> assert false

(* The outward normal for shading. *)
let rec shading (shape : Shape.t) p =
  match shape with
  | Mesh mesh when Mesh.is_smooth mesh ->
      let { Facets.normals; corner_normals; _ } = Mesh.facets mesh in
      List.combine (triangles mesh) (triples normals corner_normals)
      |> List.map (fun ((corners, _) as both) ->
             (from_triangle p corners, blended p both))
      |> of_nearest
  | Placed { own; modifiers; _ } ->
      placed_normal modifiers (shading own (undone undo_point modifiers p))
  | shape -> outward shape p

let frustum_size (f : Frustum.t) =
  List.fold_left Float.max f.length [ f.radius_a; f.radius_b ]

(* R of the offset. *)
let size : Shape.t -> float = function
  | Sphere s -> s.radius
  | Cylinder c -> frustum_size (c :> Frustum.t)
  | Cone c -> frustum_size (c :> Frustum.t)
  | Torus { ring; tube; _ } -> ring +. tube
  | Plane _ | Box _ | Disc _ | Triangle _ | Quad _ | Mesh _ | Placed _
  | Solid _ ->
      0.

let inside_frustum (f : Frustum.t) p =
  let y, q = from_axis f.a f.axis p in
  0. < y && y < f.length && length q < f.radius_a +. (f.slope *. y)

let rec inside (shape : Shape.t) p =
  match shape with
  | Sphere s -> length (p - centre s) < s.radius
  | Plane { point = q; normal } -> dot (p - q) (normal :> Vec3.t) < 0.
  | Placed { own; modifiers; _ } -> inside own (undone undo_point modifiers p)
  | Box { low; high } ->
      low.x < p.x && p.x < high.x && low.y < p.y && p.y < high.y && low.z < p.z
      && p.z < high.z
  | Cylinder c -> inside_frustum (c :> Frustum.t) p
  | Cone c -> inside_frustum (c :> Frustum.t) p
  | Torus { centre; axis; ring; tube } ->
      let y, q = from_axis centre axis p in
      let x = length q -. ring in
      (x *. x) +. (y *. y) < tube *. tube
  | Mesh _ ->
      let ray =
        { o = p; d = Vec3.make 0.2 0.5 0.7; rho = infinity; seed = 0. }
      in
      let ahead = List.filter (fun t -> t > 0.) (intersections shape ray) in
      List.length ahead mod 2 = 1
  | Disc _ | Triangle _ | Quad _ | Solid _ -> assert false

(* {1 The offset} *)

let absolute { Vec3.x; y; z } = abs_float x +. abs_float y +. abs_float z
let tangent degrees = Float.tan (degrees *. Float.pi /. 180.)

(* W, H and D *)
let canvas (camera : Camera.t) =
  let { Viewpoint.eye; look_at; _ } = camera.viewpoint in
  match camera.fov with
  | None -> (camera.canvas_width, camera.canvas_height, camera.depth)
  | Some fov ->
      let d = length (look_at - eye) in
      let w = 2. *. d *. tangent (fov /. 2.) in
      (w, w *. float_of_int camera.height /. float_of_int camera.width, d)

let usual (scene : Scene.t) =
  let w, h, d = canvas scene.camera in
  1e-5 *. Float.min (Float.min w h) d

let offset scene size p { o; _ } =
  Float.max (usual scene) (ldexp (size +. absolute p +. absolute o) (-44))

(* {1 Solids}

   A face is where a line goes through the surface of an object. *)

type face = { t : float; shape : Shape.t; surface : Surface.t; sign : float }

let rec truth is_in : int Solid.tree -> bool = function
  | Member m -> is_in m
  | Combined (Union, parts) -> List.exists (truth is_in) parts
  | Combined (Intersection, parts) -> List.for_all (truth is_in) parts
  | Combined (Difference, parts) ->
      truth is_in (List.hd parts)
      && not (List.exists (truth is_in) (List.tl parts))

(* The member that stands where the truth goes from [before] to [after], and 1,
   or -1 if it does so by being taken away. *)
let rec standing before after : int Solid.tree -> int * float = function
  | Member m -> (m, 1.)
  | Combined (operation, parts) as whole ->
      let sign k = if operation = Difference && k > 0 then -1. else 1. in
      let is_up = truth after whole in
      let changes (k, part) =
        truth before part <> truth after part
        && truth after part = (is_up = (sign k > 0.))
      in
      let numbered = List.mapi (fun k part -> (k, part)) parts in
      let k, part = List.find changes numbered in
      let m, inner = standing before after part in
      (m, sign k *. inner)

(* Crossings that are within the offset of the first, each of another member. *)
let rec coinciding scene ray = function
  | [] -> []
  | (t, m) :: rest ->
      let e = offset scene 0. (at ray t) ray in
      let rec split members taken = function
        | (t', m') :: rest when t' <= t +. e && not (List.mem m' members) ->
            split (m' :: members) ((t', m') :: taken) rest
        | rest -> (List.rev taken, rest)
      in
      let taken, rest = split [ m ] [ (t, m) ] rest in
      taken :: coinciding scene ray rest

let solid_faces scene (tree : int Solid.tree) (primitives : Object.t array) ray
    =
  let crossings =
    Array.to_list primitives
    |> List.mapi (fun m (o : Object.t) ->
           List.map (fun t -> (t, m)) (intersections o.shape ray))
    |> List.concat |> List.sort compare
  in
  let groups = coinciding scene ray crossings in
  let first group = fst (List.hd group)
  and last group = fst (List.hd (List.rev group)) in
  let is_in t m = inside primitives.(m).Object.shape (at ray t) in
  let rec faces before = function
    | [] -> []
    | group :: rest ->
        let after =
          match rest with
          | [] -> is_in (last group +. 1.)
          | next :: _ -> is_in ((last group +. first next) /. 2.)
        in
        let here =
          if truth before tree = truth after tree then []
          else
            let m, sign = standing before after tree in
            let t, _ = List.find (fun (_, m') -> m = m') group in
            let { Object.shape; surface; _ } = primitives.(m) in
            [ { t; shape; surface; sign } ]
        in
        here @ faces after rest
  in
  match groups with
  | [] -> []
  | group :: _ -> faces (is_in (first group -. 1.)) groups

let faces scene ray (o : Object.t) =
  match o.shape with
  | Solid { tree; _ } -> solid_faces scene tree o.primitives ray
  | shape ->
      List.map
        (fun t -> { t; shape; surface = o.surface; sign = 1. })
        (intersections shape ray)

(* {1 The camera} *)

let cross (u : Vec3.t) (v : Vec3.t) =
  Vec3.make
    ((u.y *. v.z) -. (u.z *. v.y))
    ((u.z *. v.x) -. (u.x *. v.z))
    ((u.x *. v.y) -. (u.y *. v.x))

(* {1 Hits} *)

(* All that count. *)
let hits (scene : Scene.t) objects ray =
  List.concat_map (faces scene ray) objects
  |> List.filter (fun { t; _ } -> 0. < t && t < ray.rho)

let first faces =
  let nearer best face =
    match best with Some b when b.t <= face.t -> best | _ -> Some face
  in
  List.fold_left nearer None faces

let nearest (scene : Scene.t) ray = first (hits scene scene.objects ray)
let facing { d; _ } n = if dot d n > 0. then -n else n

(* {1 Surfaces} *)

type refraction = {
  index : float;
  plain : Color.t;
  fresnel : Color.t;
  glass : Color.t;
}

type lobes = {
  e : Color.t;
  a : Color.t;
  shines : (float * Color.t) list;
  m : Color.t;
  refractions : refraction list;
}

let nothing =
  {
    e = Color.black;
    a = Color.black;
    shines = [];
    m = Color.black;
    refractions = [];
  }

let rec join_shines shines (s, c) =
  match shines with
  | [] -> [ (s, c) ]
  | (s', c') :: rest when s = s' -> (s, c' ++ c) :: rest
  | first :: rest -> first :: join_shines rest (s, c)

let sum_of_refractions r r' =
  {
    r with
    plain = r.plain ++ r'.plain;
    fresnel = r.fresnel ++ r'.fresnel;
    glass = r.glass ++ r'.glass;
  }

let rec join refractions r =
  match refractions with
  | [] -> [ r ]
  | first :: rest when first.index = r.index ->
      sum_of_refractions first r :: rest
  | first :: rest -> first :: join rest r

let plus l l' =
  {
    e = l.e ++ l'.e;
    a = l.a ++ l'.a;
    shines = List.fold_left join_shines l.shines l'.shines;
    m = l.m ++ l'.m;
    refractions = List.fold_left join l.refractions l'.refractions;
  }

let times k l =
  let times = Color.multiply k in
  let of_refraction r =
    {
      r with
      plain = times r.plain;
      fresnel = times r.fresnel;
      glass = times r.glass;
    }
  in
  {
    e = times l.e;
    a = times l.a;
    shines = List.map (fun (s, c) -> (s, times c)) l.shines;
    m = times l.m;
    refractions = List.map of_refraction l.refractions;
  }

(* The point in own coordinates. *)
let rec own (shape : Shape.t) p =
  match shape with
  | Placed { own = shape; modifiers; _ } ->
      own shape (undone undo_point modifiers p)
  | _ -> p

(* What an expression is; [names] has the values of all names. Of those that
   are made here. *)
type value =
  | Is_number of float
  | Is_vector of Vec3.t
  | Is_function of Expression.parameter list * Expression.t

let rec value names (e : Expression.t) =
  let number e =
    match value names e with Is_number x -> x | _ -> invalid_arg "no number"
  in
  match e.desc with
  | Number x -> Is_number x
  | Name name -> List.assoc name names
  | Triple (x, y, z) | List [ x; y; z ] ->
      Is_vector (Vec3.make (number x) (number y) (number z))
  | Part (e, letter) -> (
      match (value names e, letter) with
      | Is_vector v, 'x' -> Is_number v.x
      | Is_vector v, 'y' -> Is_number v.y
      | Is_vector v, _ -> Is_number v.z
      | _ -> invalid_arg "no vector")
  | Binary (Add, a, b) -> Is_number (number a +. number b)
  | If ({ desc = Binary (Greater, a, b); _ }, yes, no) ->
      value names (if number a > number b then yes else no)
  | Call { name; arguments = [ { value = argument; _ } ]; _ } -> (
      match List.assoc name names with
      | Is_function ([ { name; _ } ], body) ->
          value ((name, value names argument) :: names) body
      | _ -> invalid_arg "no function")
  | _ -> invalid_arg "not made here"

let names_at { Closed.name; definitions; _ } q =
  let define (name, definition) =
    match (definition : _ Closed.definition) with
    | Value (Number x) -> (name, Is_number x)
    | Defined { parameters; body } -> (name, Is_function (parameters, body))
    | Value _ -> invalid_arg "not made here"
  in
  (name, Is_vector q) :: List.map define definitions

let color_of names e =
  match value names e with
  | Is_vector { x; y; z } -> Color.make x y z
  | _ -> invalid_arg "no colour"

let number_of names e =
  match value names e with Is_number x -> x | _ -> invalid_arg "no number"

(* The surface that a word is with what its names are. *)
let rec made names (e : Expression.t) =
  match e.desc with
  | Word { word = "diffusive"; arguments = [ (_, c) ] } ->
      Surface.diffusive (color_of names c)
  | Word { word = "luminous"; arguments = [ (_, c) ] } ->
      Surface.luminous (color_of names c)
  | Word { word = "reflective"; _ } -> Surface.reflective
  | Word { word = "mixed"; arguments = [ (_, w); (_, s); (_, w'); (_, s') ] }
    ->
      let part w s = (number_of names w, made names s) in
      Surface.mixed [ part w s; part w' s' ]
  | Word { word = "checker"; arguments = [ (_, size); (_, s); (_, s') ] } ->
      Surface.checker (number_of names size) (made names s) (made names s')
  | _ -> invalid_arg "not made here"

let sky (scene : Scene.t) d =
  match scene.background with
  | Plain c -> c
  | Varying { pattern; _ } -> color_of (names_at pattern d) pattern.body

(* At the own point q. *)
let rec denotes (surface : Surface.t) (q : Vec3.t) =
  let black = Color.black in
  match surface with
  | Varying { pattern; _ } ->
      denotes (made (names_at pattern q) pattern.body) q
  | Diffusive c -> { nothing with a = c }
  | Reflective -> { nothing with m = Color.white }
  | Luminous c -> { nothing with e = c }
  | Glossy { sharpness; color } ->
      { nothing with shines = [ (sharpness, color) ] }
  | Refractive { index; color } ->
      let r = { index; plain = color; fresnel = black; glass = black } in
      { nothing with refractions = [ r ] }
  | Glass { index; color } ->
      let r = { index; plain = black; fresnel = Color.white; glass = color } in
      { nothing with refractions = [ r ] }
  | Mixed { parts; _ } ->
      let add l (k, part) = plus l (times k (denotes part q)) in
      List.fold_left add nothing parts
  | Checker { size; even; odd; _ } ->
      (* a little that no picture shows decides between two cubes *)
      let cube x = floor ((x /. size) +. 0x1p-30) in
      let sum = cube q.x +. cube q.y +. cube q.z in
      denotes (if Float.rem sum 2. = 0. then even else odd) q

(* eta, c and c', the cosines before and after; none if the ray is totally
   reflected. *)
let snell index d n ~is_outside =
  let eta = if is_outside then 1. /. index else index and c = -.dot d n in
  let squared = 1. -. (eta *. eta *. (1. -. (c *. c))) in
  if squared <= 0. then None else Some (eta, c, sqrt squared)

let fresnel (eta, c, c') =
  let across = ((eta *. c) -. c') /. ((eta *. c) +. c')
  and along = (c -. (eta *. c')) /. (c +. (eta *. c')) in
  ((across *. across) +. (along *. along)) /. 2.

(* {1 Light} *)

(* Of one point of a light: where it is, unless far away, and what of its light
   goes along a way. *)
type lamp = { place : Vec3.t option; travels : Vec3.t; cone : Vec3.t -> float }

let everywhere _ = 1.
let at_point s = { place = Some s; travels = Vec3.zero; cone = everywhere }
let cosine degrees = cos (degrees *. Float.pi /. 180.)

let cone { Beam.position; target; inner; outer; _ } way =
  let c = dot (unit way) (unit (target - position)) in
  let t = (c -. cosine outer) /. (cosine inner -. cosine outer) in
  if c >= cosine inner then 1.
  else if c <= cosine outer then 0.
  else (3. *. (t ** 2.)) -. (2. *. (t ** 3.))

let lamps seed (light : Light.t) =
  match light.source with
  | Directional along ->
      [ { place = None; travels = (along :> Vec3.t); cone = everywhere } ]
  | Spherical s -> [ at_point s ]
  | Spot beam -> [ { (at_point beam.position) with cone = cone beam } ]
  | Area ({ corner; edge; other; count } as pane) ->
      List.init (Int.mul count count) (fun k ->
          let u = Pane.across pane k ~seed and v = Pane.along pane k ~seed in
          at_point (corner + (u * edge) + (v * other)))

(* With what there is in the place of the cosine; both normals, that of the
   surface and that for shading, must face the light. *)
let received (light : Light.t) { place; travels; cone } p (n, s) instead =
  let l, f =
    match place with
    | None -> (-travels, 1.)
    | Some s ->
        let d2 = dot (s - p) (s - p) in
        (unit (s - p), if light.is_unfading then 1. else 1. /. d2)
  in
  if dot n l <= 0. || dot s l <= 0. then Color.black
  else Color.scale (instead l *. f *. cone (-l) *. light.intensity) light.color

let shadow_ray { place; travels; _ } a e =
  match place with
  | None -> { o = a; d = -travels; rho = infinity; seed = 0. }
  | Some s -> { o = a; d = unit (s - a); rho = length (s - a) -. e; seed = 0. }

(* What a surface lets through of light that comes along d. *)
let lets_through surface q d n =
  let add sum r =
    let f =
      match snell r.index d n ~is_outside:true with
      | None -> 1.
      | Some s -> fresnel s
    in
    sum ++ r.plain ++ Color.scale (1. -. f) r.glass
  in
  List.fold_left add Color.black (denotes surface q).refractions

(* The normal for shading on the side from which d comes, or that of the surface
   where it faces away from there. *)
let shaded shape sign p d ~n ~outward =
  let s = sign * shading shape p in
  let s = if n = outward then s else -s in
  if dot d s < 0. then s else n

let rec visible scene objects ray =
  match first (hits scene objects ray) with
  | None -> Color.white
  | Some { t; shape; surface; sign } ->
      let p = at ray t in
      let outward = sign * outward shape p in
      let n = facing ray outward in
      let s = shaded shape sign p ray.d ~n ~outward in
      let e = offset scene (size shape) p ray in
      let behind = { ray with o = p - (e * n); rho = ray.rho -. t } in
      let part = lets_through surface (own shape p) ray.d s in
      if Color.largest part = 0. then Color.black
      else Color.multiply part (visible scene objects behind)

let by_glass (o : Object.t) =
  if Glasses.lets_through o then Either.Right o else Left o

let light scene p (n, s) e seed instead =
  let casting = List.filter (fun (o : Object.t) -> not o.is_shadowless) in
  let objects = casting scene.Scene.objects in
  let gives light =
    let lamps = lamps seed light in
    (* what lets nothing through blocks, even where glass coincides with it *)
    let opaque, clear = List.partition_map by_glass objects in
    let gives lamp =
      let ray = shadow_ray lamp (p + (e * n)) e in
      let visible =
        if hits scene opaque ray <> [] then Color.black
        else visible scene clear ray
      in
      Color.multiply visible (received light lamp p (n, s) instead)
    in
    Color.scale
      (1. /. float_of_int (List.length lamps))
      (List.fold_left ( ++ ) Color.black (List.map gives lamps))
  in
  List.fold_left ( ++ ) Color.black (List.map gives scene.lights)

(* {1 Tracing} *)

(* What goes on, each with its weight: the mirrored ray and the refracted
   ones. *)
let sent_on { m; refractions; _ } p ({ d; _ } as ray) (n, s) e ~is_outside =
  let leave side d =
    (* a normal for shading may bend it to the other side *)
    let side = if n = s then side else Float.copy_sign 1. (dot n d) in
    { ray with o = p + (side *. e * n); d; rho = infinity }
  in
  let refraction (m, others) r =
    match snell r.index d s ~is_outside with
    | None -> (m ++ r.plain ++ r.fresnel, others)
    | Some ((eta, c, c') as bent) ->
        let f = fresnel bent in
        let d' = (eta * d) + (((eta *. c) -. c') * s) in
        let t = r.plain ++ Color.scale (1. -. f) r.glass in
        (m ++ Color.scale f r.fresnel, (t, leave (-1.) (unit d')) :: others)
  in
  let m, others = List.fold_left refraction (m, []) refractions in
  (m, leave 1. (mirrored d s)) :: List.rev others
  |> List.filter (fun (weight, _) -> Color.largest weight > 0.)

let shared share weights =
  let sum = List.fold_left ( +. ) 0. weights in
  match weights with
  | [ _ ] -> [ share ]
  | _ -> List.map (fun w -> share *. w /. Float.max 1. sum) weights

let rec trace ?(share = 1.) (scene : Scene.t) left ray =
  let is_followed = left > 0 && share >= 1. /. 1024. in
  match if is_followed then nearest scene ray else None with
  | None -> sky scene ray.d
  | Some { t; shape; surface; sign } ->
      let p = at ray t in
      let outward = sign * outward shape p in
      let n = facing ray outward and e = offset scene (size shape) p ray in
      let s = shaded shape sign p ray.d ~n ~outward in
      let is_outside = dot ray.d outward <= 0.
      and lobes = denotes surface (own shape p) in
      let sent = sent_on lobes p ray (n, s) e ~is_outside in
      let shares =
        shared share (List.map (fun (w, _) -> Color.largest w) sent)
      in
      let light = light scene p (n, s) e ray.seed in
      let diffused = scene.ambient ++ light (dot s)
      and shine (sharpness, c) =
        let power l = Float.max 0. (dot (mirrored ray.d s) l) ** sharpness in
        Color.multiply c (light power)
      in
      List.fold_left2
        (fun sum (weight, ray) share ->
          sum ++ Color.multiply weight (trace ~share scene (pred left) ray))
        (List.fold_left ( ++ )
           (lobes.e ++ Color.multiply lobes.a diffused)
           (List.map shine lobes.shines))
        sent shares

(* {1 Pixels} *)

let frame (camera : Camera.t) =
  let { Viewpoint.eye; look_at; up; _ } = camera.viewpoint in
  let f = unit (look_at - eye) in
  let r = unit (cross up f) in
  (r, cross f r, f)

(* Through the place (x', y') of pixel (x, y), from its upper left corner. *)
let sight ({ Camera.width; height; _ } as camera) x y x' y' =
  let { Viewpoint.eye; _ } = camera.viewpoint and r, u, f = frame camera in
  let canvas_width, canvas_height, depth = canvas camera in
  let place extent count k part =
    (extent *. (float_of_int k +. part) /. float_of_int count) -. (extent /. 2.)
  in
  let across = place canvas_width width x x'
  and above =
    place canvas_height height (Int.sub (pred height) y) (1. -. y')
  in
  let q = eye + (depth * f) + (across * r) + (above * u) in
  { o = eye; d = unit (q - eye); rho = infinity; seed = 0. }

let exposed (scene : Scene.t) c =
  let channel v = Float.min 1. (scene.film.exposure *. v) in
  Color.make (channel c.Color.r) (channel c.g) (channel c.b)

let through_lens (scene : Scene.t) pixel k ({ o; d; _ } as ray) =
  let { Lens.aperture; focus } = scene.lens in
  if scene.film.samples = 1 || aperture = 0. then ray
  else
    let _, _, depth = canvas scene.camera and r, u, f = frame scene.camera in
    let psi = Option.value focus ~default:depth in
    let turn = 2. *. Float.pi *. Spread.lens' pixel k in
    let radius = aperture *. sqrt (Spread.lens pixel k) in
    let l = o + (radius * ((cos turn * r) + (sin turn * u))) in
    let z = o + (psi /. dot d f * d) in
    { ray with o = l; d = unit (z - l) }

let sample (scene : Scene.t) x y k =
  let pixel = Spread.of_pixel ~x ~y in
  let u, v =
    if k = 0 then (0.5, 0.5) else (Spread.across pixel k, Spread.down pixel k)
  in
  let ray = through_lens scene pixel k (sight scene.camera x y u v) in
  let ray = { ray with seed = Spread.seed pixel k } in
  exposed scene (trace scene scene.ray_depth ray)

let curve v =
  if v <= 0.0031308 then 12.92 *. v else (1.055 *. (v ** (1. /. 2.4))) -. 0.055

(* As a picture shows them. *)
let differ (scene : Scene.t) (a : Color.t) (b : Color.t) =
  let shown v = if scene.film.srgb then curve v else v in
  let apart v w = abs_float (shown v -. shown w) > 1. /. 32. in
  apart a.r b.r || apart a.g b.g || apart a.b b.b

let neighbours { Camera.width; height; _ } x y =
  let near k = [ pred k; k; succ k ] in
  List.concat_map (fun x -> List.map (fun y -> (x, y)) (near y)) (near x)
  |> List.filter (fun (x, y) -> 0 <= x && x < width && 0 <= y && y < height)

let rec refined scene x y taken =
  let most = scene.Scene.film.samples and n = List.length taken in
  let two_differ = List.exists (fun a -> List.exists (differ scene a) taken) in
  if n < most && two_differ taken then
    let more = Int.min n (Int.sub most n) in
    let further = List.init more (fun k -> sample scene x y (Int.add n k)) in
    refined scene x y (taken @ further)
  else taken

let samples (scene : Scene.t) x y =
  let most = scene.film.samples and centre = sample scene x y 0 in
  let is_other (x, y) = differ scene centre (sample scene x y 0) in
  if most > 1 && List.exists is_other (neighbours scene.camera x y) then
    refined scene x y (List.init (Int.min 4 most) (sample scene x y))
  else [ centre ]

let pixel scene ~x ~y =
  let taken = samples scene x y in
  Color.scale
    (1. /. float_of_int (List.length taken))
    (List.fold_left ( ++ ) Color.black taken)

(* {1 The tracer beside them} *)

let near (a : Color.t) (b : Color.t) =
  let near x y = abs_float (x -. y) <= 1e-7 *. (1. +. abs_float x) in
  near a.r b.r && near a.g b.g && near a.b b.b

let same =
  Property.holds "the tracer is the equations" ~count:1000
    ~print:(Property.show Scene.pp)
    (Generate.scene ~max_side:6 Generate.everyday) (fun scene ->
      let prepared = Prepared.make scene in
      let { Camera.width; height; _ } = scene.camera in
      Seq.for_all
        (fun (x, y) -> near (Tracer.pixel prepared ~x ~y) (pixel scene ~x ~y))
        (Seq.product
           (Seq.take width (Seq.ints 0))
           (Seq.take height (Seq.ints 0))))

let suite = ("Semantics", [ same ])

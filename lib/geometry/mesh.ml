open Unchecked

type t = {
  file : string;
  facets : Facets.t;
  is_smooth : bool;
  box : Box3.t;
  middle : Vec3.t; (* the mean of all corners *)
  open_edge : Mesh_edges.edge option;
  spheres : Bvh_walk.spheres; (* the tree, and no spheres *)
}

let name = "mesh"
let file mesh = mesh.file
let facets mesh = mesh.facets
let is_smooth mesh = mesh.is_smooth
let box mesh = mesh.box
let open_edge mesh = mesh.open_edge
let is_closed mesh = Option.is_none mesh.open_edge

let volume { facets; _ } =
  Mesh_edges.volume facets ~apex:(Mesh_edges.point facets facets.corners.(0))

(* {1 Making} *)

let leaves (facets : Facets.t) =
  let count = Facets.count facets in
  let leaves = Bvh_leaves.create ~kinds:(fun _ -> Bvh_leaves.Other) count in
  for triangle = 0 to count - 1 do
    let coordinate k axis =
      facets.points.((3 * facets.corners.((3 * triangle) + k)) + axis)
    in
    for axis = 0 to 2 do
      let a = coordinate 0 axis
      and b = coordinate 1 axis
      and c = coordinate 2 axis in
      let set side x = Bvh_leaves.set_side leaves triangle side x in
      set (2 * axis) (Float.min a (Float.min b c));
      set ((2 * axis) + 1) (Float.max a (Float.max b c))
    done
  done;
  leaves

let box_of leaves =
  let count = Bvh_leaves.count leaves in
  let side choose k =
    let best = ref (Bvh_leaves.side leaves 0 k) in
    for place = 1 to count - 1 do
      best := choose !best (Bvh_leaves.side leaves place k)
    done;
    !best
  in
  let corner choose first =
    Vec3.make (side choose first)
      (side choose (first + 2))
      (side choose (first + 4))
  in
  Box3.make ~low:(corner Float.min 0) ~high:(corner Float.max 1)

let middle_of (facets : Facets.t) =
  let add sum corner = Vec3.add sum (Mesh_edges.point facets corner) in
  let sum = Array.fold_left add Vec3.zero facets.corners in
  Vec3.scale (1. /. float_of_int (Array.length facets.corners)) sum

let require (facets : Facets.t) =
  let count = Facets.count facets in
  let are_among numbers ~least indexes =
    let stop = Array.length numbers / 3 in
    Array.for_all (fun k -> least <= k && k < stop) indexes
  in
  if
    count = 0
    || Array.length facets.corners <> 3 * count
    || (not (are_among facets.points ~least:0 facets.corners))
    || (not (Array.for_all Float.is_finite facets.points))
    || not (are_among facets.normals ~least:(-1) facets.corner_normals)
  then invalid_arg "no facets of a mesh"

let make ?(domains = 1) ~name:file (facets : Facets.t) =
  require facets;
  let leaves = leaves facets in
  let box = box_of leaves in
  let tree = Bvh_tree.compact (Bvh_tree.build ~domains leaves) in
  {
    file;
    facets;
    is_smooth = false;
    box;
    middle = middle_of facets;
    open_edge = Mesh_edges.open_edge facets ~places:(Mesh_edges.places facets);
    spheres = { tree; numbers = Bvh_leaves.numbers leaves; rows = [||] };
  }

let smooth (facets : Facets.t) mesh =
  require facets;
  let is_same =
    facets.corners = mesh.facets.corners && facets.points = mesh.facets.points
  and has_all =
    Array.length facets.corner_normals = Array.length facets.corners
    && Array.for_all (fun k -> k >= 0) facets.corner_normals
  in
  if not (is_same && has_all) then
    invalid_arg "a smooth mesh has a normal at each corner";
  { mesh with facets; is_smooth = true }

(* {1 What is hit} *)

let[@inline] corner { facets; _ } triangle k =
  Array.unsafe_get facets.corners ((3 * triangle) + k)

let[@inline] meet mesh sheared triangle =
  Triangle_ray.meet sheared mesh.facets.points (corner mesh triangle 0)
    (corner mesh triangle 1) (corner mesh triangle 2)

let offer_leaf mesh code (ray : Raw_ray.t) (meeting : Meeting.t) ~number =
  let sheared = meeting.room.mesh.sheared in
  for place = Bvh_tree.leaf_first code to Bvh_tree.leaf_last code do
    let triangle = mesh.spheres.numbers.(place) in
    if meet mesh sheared triangle then
      Meeting.offer meeting ray ~number ~part:triangle
        (Triangle_ray.distance sheared)
  done

let rec offer_from mesh code ray (meeting : Meeting.t) ~number =
  if code <> Bvh_tree.none then (
    offer_leaf mesh code ray meeting ~number;
    offer_from mesh
      (Bvh_walk.go_on ~any:false mesh.spheres meeting.room.mesh ray meeting)
      ray meeting ~number)

let offer mesh ray (meeting : Meeting.t) ~number =
  let scratch = meeting.room.mesh in
  Triangle_ray.set scratch.sheared ray;
  offer_from mesh
    (Bvh_walk.start ~any:false mesh.spheres scratch ray meeting)
    ray meeting ~number

(* No tree of triangles has a sphere that could offer itself. *)
let nobody = Meeting.create ()

(* Those before the origin, if [ahead], or else the others. Of a mesh that is
   open each is crossed twice at one place, as all that is flat is. *)
let rec insert_from mesh code ray (crossings : Crossings.t) ~ahead =
  if code <> Bvh_tree.none then (
    let scratch = crossings.mesh in
    for place = Bvh_tree.leaf_first code to Bvh_tree.leaf_last code do
      let triangle = mesh.spheres.numbers.(place) in
      if meet mesh scratch.sheared triangle then
        let t = Triangle_ray.distance scratch.sheared in
        if ahead = (t > 0.) then (
          Crossings.insert crossings ~part:triangle t;
          if not (is_closed mesh) then
            Crossings.insert crossings ~part:triangle t)
    done;
    insert_from mesh
      (Bvh_walk.go_on ~any:false mesh.spheres scratch ray nobody)
      ray crossings ~ahead)

let crossings mesh (ray : Raw_ray.t) (crossings : Crossings.t) =
  Crossings.clear crossings ~starts_inside:false;
  let scratch = crossings.mesh and { Raw_ray.dx; dy; dz; reach; _ } = ray in
  Triangle_ray.set scratch.sheared ray;
  ray.reach <- infinity;
  let look ~ahead =
    insert_from mesh
      (Bvh_walk.start ~any:false mesh.spheres scratch ray nobody)
      ray crossings ~ahead
  in
  look ~ahead:true;
  Raw_ray.set_direction ray (-.dx) (-.dy) (-.dz);
  look ~ahead:false;
  Raw_ray.set_direction ray dx dy dz;
  ray.reach <- reach;
  (* by rounding errors only; what is entered is left *)
  if crossings.count land 1 = 1 then crossings.count <- crossings.count - 1

(* {1 The spot} *)

let[@inline] coordinate { facets; _ } part k axis =
  facets.points.((3 * facets.corners.((3 * part) + k)) + axis)

let largest_coordinate mesh part =
  let largest = ref 0. in
  for k = 0 to 2 do
    for axis = 0 to 2 do
      largest := Float.max !largest (abs_float (coordinate mesh part k axis))
    done
  done;
  !largest

(* The weighted sum of three of [numbers], on one axis. *)
let[@inline] blend (numbers : float array) a b c axis wa wb wc =
  (wa *. numbers.%((3 * a) + axis))
  +. (wb *. numbers.%((3 * b) + axis))
  +. (wc *. numbers.%((3 * c) + axis))

let set_smooth_normal { facets; _ } part spot wb wc =
  let wa = 1. -. wb -. wc and first = 3 * part in
  let a = facets.corner_normals.(first)
  and b = facets.corner_normals.(first + 1)
  and c = facets.corner_normals.(first + 2) in
  let nx = blend facets.normals a b c 0 wa wb wc
  and ny = blend facets.normals a b c 1 wa wb wc
  and nz = blend facets.normals a b c 2 wa wb wc in
  let squared = (nx *. nx) +. (ny *. ny) +. (nz *. nz) in
  if squared > 0. then
    let scale = 1. /. sqrt squared in
    Spot.set_shading_normal spot (nx *. scale) (ny *. scale) (nz *. scale)

(* The foot of the ray's end on the plane of the triangle, as A + wb (B - A) +
   wc (C - A): a coordinate that all corners share, it has. A triangle whose
   area doubles cannot tell has the ray's end, and a normal along the ray. *)
let settle mesh ~part (ray : Raw_ray.t) (spot : Spot.t) =
  let ax = coordinate mesh part 0 0
  and ay = coordinate mesh part 0 1
  and az = coordinate mesh part 0 2 in
  let ux = coordinate mesh part 1 0 -. ax
  and uy = coordinate mesh part 1 1 -. ay
  and uz = coordinate mesh part 1 2 -. az
  and vx = coordinate mesh part 2 0 -. ax
  and vy = coordinate mesh part 2 1 -. ay
  and vz = coordinate mesh part 2 2 -. az in
  let nx = (uy *. vz) -. (uz *. vy)
  and ny = (uz *. vx) -. (ux *. vz)
  and nz = (ux *. vy) -. (uy *. vx) in
  let squared = (nx *. nx) +. (ny *. ny) +. (nz *. nz) in
  let x = Raw_ray.end_x ray
  and y = Raw_ray.end_y ray
  and z = Raw_ray.end_z ray in
  spot.size <- largest_coordinate mesh part;
  if squared > 0. && squared < infinity then (
    let px = x -. ax and py = y -. ay and pz = z -. az in
    let scale = 1. /. sqrt squared in
    let wb =
      ((((py *. vz) -. (pz *. vy)) *. nx)
      +. (((pz *. vx) -. (px *. vz)) *. ny)
      +. (((px *. vy) -. (py *. vx)) *. nz))
      /. squared
    and wc =
      ((((uy *. pz) -. (uz *. py)) *. nx)
      +. (((uz *. px) -. (ux *. pz)) *. ny)
      +. (((ux *. py) -. (uy *. px)) *. nz))
      /. squared
    in
    let x = ax +. (wb *. ux) +. (wc *. vx)
    and y = ay +. (wb *. uy) +. (wc *. vy)
    and z = az +. (wb *. uz) +. (wc *. vz) in
    Spot.set_normal spot (nx *. scale) (ny *. scale) (nz *. scale);
    Spot.set_point spot x y z;
    Spot.set_own spot x y z;
    if mesh.is_smooth then set_smooth_normal mesh part spot wb wc)
  else (
    Spot.set_normal spot ray.dx ray.dy ray.dz;
    Spot.set_point spot x y z;
    Spot.set_own spot x y z)

(* {1 Depth} *)

let point { facets; _ } = Mesh_edges.point facets

(* A point is inside if a ray from it crosses the mesh an odd number of times. *)
let is_inside mesh { Vec3.x; y; z } =
  let ray = Raw_ray.create () and found = Crossings.create () in
  Raw_ray.set_origin ray x y z;
  crossings mesh ray found;
  let ahead = ref 0 in
  for k = 0 to found.count - 1 do
    if found.distances.(k) > 0. then incr ahead
  done;
  !ahead land 1 = 1

let distance_to_box { Box3.low; high } { Vec3.x; y; z } =
  let beyond x low high = Float.max 0. (Float.max (low -. x) (x -. high)) in
  Vec3.length
    (Vec3.make (beyond x low.x high.x) (beyond y low.y high.y)
       (beyond z low.z high.z))

let distance_to_surface mesh p =
  let corner part k =
    let at = coordinate mesh part k in
    Vec3.make (at 0) (at 1) (at 2)
  in
  let nearest = ref infinity in
  for part = 0 to Facets.count mesh.facets - 1 do
    let from = Nearest_point.of_triangle p in
    let q = from (corner part 0) (corner part 1) (corner part 2) in
    nearest := Float.min !nearest (Vec3.length (Vec3.sub p q))
  done;
  !nearest

let depth mesh p =
  if not (is_closed mesh) then neg_infinity
  else
    let beside = distance_to_box mesh.box p in
    if beside > 0. then -.beside
    else if is_inside mesh p then distance_to_surface mesh p
    else -.distance_to_surface mesh p

(* {1 What is told} *)

let part mesh k =
  Printf.sprintf "face %d (%s of %s)" mesh.facets.faces.(k)
    (Facets.place mesh.facets k)
    mesh.file

let opening mesh =
  let tell { Mesh_edges.triangle; side; faces } =
    let corner k = point mesh mesh.facets.corners.((3 * triangle) + k) in
    Format.asprintf "%s has an edge from %a to %a that %s" (part mesh triangle)
      Vec3.pp (corner side) Vec3.pp
      (corner ((side + 1) mod 3))
      (if faces = 1 then "no other face has"
       else Printf.sprintf "%d faces have" faces)
  in
  Option.map tell mesh.open_edge

let parameters mesh : (string * Parameter.t) list =
  ("file", Text mesh.file)
  :: (if mesh.is_smooth then [ ("shading", Parameter.Word "smooth") ] else [])

(* Enough for a drawing of a few hundred pixels. *)
let most_points = 500

let some_points mesh =
  let count = Array.length mesh.facets.corners in
  let step = 1 + (count / most_points) in
  List.init
    (((count - 1) / step) + 1)
    (fun k -> point mesh mesh.facets.corners.(k * step))

let place { box = { low; high }; middle; facets; _ } =
  let triangles = float_of_int (Facets.count facets) in
  [|
    low.x; low.y; low.z; high.x; high.y; high.z; middle.x; middle.y; middle.z;
    triangles;
  |]
[@@ocamlformat "disable"]

let equal a b =
  a == b
  || a.is_smooth = b.is_smooth
     && (a.facets == b.facets || a.facets = b.facets)

let pp ppf mesh =
  Format.pp_print_string ppf name;
  List.iter
    (fun (_, parameter) ->
      Format.fprintf ppf " %a" (Parameter.pp_with Number.pp) parameter)
    (parameters mesh)

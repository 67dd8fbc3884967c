type t = {
  spheres : Bvh_walk.spheres; (* those in the tree *)
  planes : Plane.t array;
      (* outside of the tree, where most scenes have a few *)
  plane_numbers : int array;
  endless : Shape.t array; (* all others that are outside of it *)
  endless_numbers : int array;
  shapes : Shape.t array; (* all, by number *)
}

let[@inline never] offer_others { spheres; shapes; _ } code ray meeting =
  for place = Bvh_tree.leaf_first code to Bvh_tree.leaf_last code do
    let number = spheres.numbers.(place) in
    Shape.offer shapes.(number) ray meeting ~number
  done

(* After the leaf [code] of other shapes. *)
let rec after ~any bvh walk ray meeting code =
  if code <> Bvh_tree.none then (
    offer_others bvh code ray meeting;
    if not (any && not (Meeting.is_none meeting)) then
      after ~any bvh walk ray meeting
        (Bvh_walk.go_on ~any bvh.spheres walk ray meeting))

let[@inline] search ~any bvh walk ray meeting =
  let code = Bvh_walk.start ~any bvh.spheres walk ray meeting in
  if code <> Bvh_tree.none then after ~any bvh walk ray meeting code

(* {1 Questions} *)

let[@inline] offer_plane { planes; plane_numbers; _ } k ray meeting =
  Plane.offer
    (Array.unsafe_get planes k)
    ray meeting
    ~number:(Array.unsafe_get plane_numbers k)

let offer_endless { endless; endless_numbers; _ } k ray meeting =
  Shape.offer endless.(k) ray meeting ~number:endless_numbers.(k)

let nearest bvh walk ray meeting =
  Meeting.clear meeting;
  for k = 0 to Array.length bvh.planes - 1 do
    offer_plane bvh k ray meeting
  done;
  for k = 0 to Array.length bvh.endless - 1 do
    offer_endless bvh k ray meeting
  done;
  search ~any:false bvh walk ray meeting

let rec offer_planes_until_one bvh k ray meeting =
  if k < Array.length bvh.planes then (
    offer_plane bvh k ray meeting;
    if Meeting.is_none meeting then
      offer_planes_until_one bvh (k + 1) ray meeting)

let rec offer_endless_until_one bvh k ray meeting =
  if k < Array.length bvh.endless then (
    offer_endless bvh k ray meeting;
    if Meeting.is_none meeting then
      offer_endless_until_one bvh (k + 1) ray meeting)

(* Most shapes that block are spheres: a comparison, where {!Shape.offer} jumps
   through a table. *)
let[@inline] offer_last { shapes; _ } last ray blocker =
  match shapes.(last) with
  | Shape.Sphere s -> Sphere.offer s ray blocker ~number:last
  | shape -> Shape.offer shape ray blocker ~number:last

(* How many series of rays have their last blocker remembered. *)
let max_series = 64

(* Neighbouring points are often in the shadow of the same shape: the one that
   last blocked a ray of the series is asked first. *)
let blocked bvh walk last_blockers (blocker : Meeting.t) series ray =
  let series = series land (max_series - 1) in
  let last = last_blockers.(series) in
  Meeting.clear blocker;
  if last <> Meeting.none then offer_last bvh last ray blocker;
  if Meeting.is_none blocker then (
    offer_planes_until_one bvh 0 ray blocker;
    if Meeting.is_none blocker then offer_endless_until_one bvh 0 ray blocker;
    if Meeting.is_none blocker then search ~any:true bvh walk ray blocker;
    if not (Meeting.is_none blocker) then
      last_blockers.(series) <- blocker.number);
  not (Meeting.is_none blocker)

(* {1 Building} *)

let index ?(domains = 1) shapes =
  let plane (number, shape) =
    match shape with Shape.Plane plane -> Some (number, plane) | _ -> None
  and other_endless (_, shape) =
    match shape with
    | Shape.Plane _ -> false
    | _ -> Option.is_none (Shape.box shape)
  in
  let all = Array.to_seqi shapes in
  let planes = Array.of_seq (Seq.filter_map plane all)
  and endless = Array.of_seq (Seq.filter other_endless all) in
  let leaves = Shape_leaves.of_shapes shapes in
  let tree = Bvh_tree.build ~domains leaves in
  let numbers = Bvh_leaves.numbers leaves in
  let bvh =
    {
      spheres = { tree; numbers; rows = Shape_leaves.spheres shapes numbers };
      planes = Array.map snd planes;
      plane_numbers = Array.map fst planes;
      endless = Array.map snd endless;
      endless_numbers = Array.map fst endless;
      shapes;
    }
  in
  fun () ->
    let walk = Mesh_scratch.create ()
    and last_blockers = Array.make max_series Meeting.none
    and blocker = Meeting.create () in
    {
      Finder.nearest = nearest bvh walk;
      blocked = blocked bvh walk last_blockers blocker;
    }

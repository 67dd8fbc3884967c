type t = {
  spheres : Bvh_walk.spheres; (* those in the tree *)
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

(* {1 Questions} *)

let[@inline] search ~any bvh walk ray meeting =
  let code = Bvh_walk.start ~any bvh.spheres walk ray meeting in
  if code <> Bvh_tree.none then after ~any bvh walk ray meeting code

let nearest bvh walk ray meeting = search ~any:false bvh walk ray meeting
let some bvh walk ray meeting = search ~any:true bvh walk ray meeting

(* {1 Building} *)

type walk = Mesh_scratch.t

let make_walk = Mesh_scratch.create

let make ?(domains = 1) shapes =
  let leaves = Shape_leaves.of_shapes shapes in
  let tree = Bvh_tree.build ~domains leaves in
  let numbers = Bvh_leaves.numbers leaves in
  {
    spheres = { tree; numbers; rows = Shape_leaves.spheres shapes numbers };
    shapes;
  }

(* {1 What it costs} *)

(* Testing a sphere, where a step of the way through the tree is 1. *)
let test = 0.2

(* Half the surface. *)
let area low high =
  let extent k = high k -. low k in
  (extent 0 *. extent 1) +. (extent 1 *. extent 2) +. (extent 2 *. extent 0)

(* A line that crosses a box crosses a smaller one in it as often as the areas
   of their surfaces are to each other. *)
let cost { spheres = { tree = { boxes; links; root; _ }; _ }; _ } =
  let rec sum code area_of_it =
    if code >= 0 then
      let child k =
        let at = (12 * code) + (6 * k) in
        sum
          links.{(3 * code) + k}
          (area
             (fun k -> boxes.{at + (2 * k)})
             (fun k -> boxes.{at + (2 * k) + 1}))
      in
      area_of_it +. child 0 +. child 1
    else
      let shapes = Bvh_tree.(leaf_last code - leaf_first code + 1) in
      test *. float_of_int shapes *. area_of_it
  in
  if root < 0 then 0.
  else
    let at = 12 * root in
    let whole =
      area
        (fun k -> Float.min boxes.{at + (2 * k)} boxes.{at + 6 + (2 * k)})
        (fun k -> Float.max boxes.{at + (2 * k) + 1} boxes.{at + 7 + (2 * k)})
    in
    sum root whole /. whole

let numbers bvh = bvh.spheres.numbers
let spheres bvh = bvh.spheres.rows

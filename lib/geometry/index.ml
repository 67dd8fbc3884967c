open Raylab_parallel

(* What is made for many rays. *)
type aids = {
  leaves : Leaves.t;
  eye : Fan.t option;
  lights : Fan.t option array;
  grid : Grid.t option; (* for all other rays *)
}

type hierarchy = {
  shapes : Shape.t array;
  endless : Endless.t;
  bvh : Bvh.t;
  aids : aids option;
}

type t = Brute_force of Shape.t array | Hierarchy of hierarchy

let brute_force shapes = Brute_force shapes

let hierarchy ?(domains = 1) shapes =
  Hierarchy
    {
      shapes;
      endless = Endless.of_shapes shapes;
      bvh = Bvh.make ~domains shapes;
      aids = None;
    }

(* {1 Fans} *)

(* Shapes lie in about three cells each, and a face has about as many cells. *)
let most_references leaves = 4096 + (16 * Leaves.count leaves)

let make_fans ~domains ~eye ~lights leaves =
  let sources = Array.append [| eye |] lights in
  let made = Array.map (fun _ -> None) sources in
  let make () k =
    made.(k) <-
      Option.bind sources.(k) (Fan.make leaves ~most:(most_references leaves))
  in
  let count = Array.length sources in
  ignore (Parallel.iter ~domains ~worker:ignore ~count make);
  (made.(0), Array.sub made 1 (count - 1))

(* A grid, if it is a shorter way than the tree. *)
let make_grid bvh leaves =
  match Grid.make leaves with
  | Some grid when Grid.cost grid < Bvh.cost bvh -> Some grid
  | _ -> None

let for_many_rays ?(domains = 1) ?eye ~lights = function
  | Brute_force _ as index -> index
  | Hierarchy ({ shapes; bvh; _ } as h) ->
      let leaves =
        Leaves.make shapes ~numbers:(Bvh.numbers bvh) ~balls:(Bvh.spheres bvh)
      in
      let eye, lights = make_fans ~domains ~eye ~lights leaves
      and grid = make_grid bvh leaves in
      Hierarchy { h with aids = Some { leaves; eye; lights; grid } }

(* {1 Questions} *)

let nearest { endless; bvh; aids; _ } walk ray meeting =
  Meeting.clear meeting;
  Endless.offer endless ray meeting;
  match aids with
  | Some { eye = Some fan; leaves; _ } when Fan.has_ray_from fan ray ->
      Fan.nearest fan leaves ray meeting
  | Some { grid = Some grid; leaves; _ } when Grid.has_ray_from grid ray ->
      Grid.nearest grid leaves ray meeting
  | _ -> Bvh.nearest bvh walk ray meeting

let fan_of lights series =
  if series >= 1 && series <= Array.length lights then lights.(series - 1)
  else None

let some_bounded { bvh; aids; _ } walk series ray meeting =
  match aids with
  | None -> Bvh.some bvh walk ray meeting
  | Some { lights; leaves; grid; _ } -> (
      match (fan_of lights series, grid) with
      | Some fan, _ when Fan.has_ray_to fan ray ->
          Fan.some fan leaves ray meeting
      | _, Some grid when Grid.has_ray_from grid ray ->
          Grid.some grid leaves ray meeting
      | _ -> Bvh.some bvh walk ray meeting)

(* How many series of rays have their last blocker remembered. *)
let max_series = 64

(* Most shapes that block are spheres: a comparison, where {!Shape.offer} jumps
   through a table. *)
let[@inline] offer_last { shapes; _ } last ray blocker =
  match shapes.(last) with
  | Shape.Sphere s -> Sphere.offer s ray blocker ~number:last
  | shape -> Shape.offer shape ray blocker ~number:last

(* Neighbouring points are often in the shadow of the same shape: the one that
   last blocked a ray of the series is asked first. *)
let blocked h walk last_blockers (blocker : Meeting.t) series ray =
  let place = series land (max_series - 1) in
  let last = last_blockers.(place) in
  Meeting.clear blocker;
  if last <> Meeting.none then offer_last h last ray blocker;
  if Meeting.is_none blocker then (
    Endless.offer_until_one h.endless ray blocker;
    if Meeting.is_none blocker then some_bounded h walk series ray blocker;
    if not (Meeting.is_none blocker) then
      last_blockers.(place) <- blocker.number);
  not (Meeting.is_none blocker)

let ask_all shapes =
  let offer_all ray meeting =
    Meeting.clear meeting;
    Array.iteri
      (fun number shape -> Shape.offer shape ray meeting ~number)
      shapes
  and blocker = Meeting.create () in
  {
    Finder.nearest = offer_all;
    blocked =
      (fun _ ray ->
        offer_all ray blocker;
        not (Meeting.is_none blocker));
  }

let ask = function
  | Brute_force shapes -> ask_all shapes
  | Hierarchy h ->
      let walk = Bvh.make_walk ()
      and last_blockers = Array.make max_series Meeting.none
      and blocker = Meeting.create () in
      {
        Finder.nearest = nearest h walk;
        blocked = blocked h walk last_blockers blocker;
      }

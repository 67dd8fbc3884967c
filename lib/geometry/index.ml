open Raylab_parallel

type fans = {
  leaves : Fan_leaves.t;
  eye : Fan.t option;
  lights : Fan.t option array;
}

type hierarchy = {
  shapes : Shape.t array;
  endless : Endless.t;
  bvh : Bvh.t;
  fans : fans option;
}

type t = Brute_force of Shape.t array | Hierarchy of hierarchy

let brute_force shapes = Brute_force shapes

let hierarchy ?(domains = 1) shapes =
  Hierarchy
    {
      shapes;
      endless = Endless.of_shapes shapes;
      bvh = Bvh.make ~domains shapes;
      fans = None;
    }

(* {1 Fans} *)

(* Shapes lie in about three cells each, and a face has about as many cells. *)
let most_references leaves = 4096 + (16 * Fan_leaves.count leaves)

let make_fans ~domains ~eye ~lights leaves =
  let sources = Array.append [| eye |] lights in
  let made = Array.map (fun _ -> None) sources in
  let make () k =
    made.(k) <-
      Option.bind sources.(k) (Fan.make leaves ~most:(most_references leaves))
  in
  let count = Array.length sources in
  ignore (Parallel.iter ~domains ~worker:ignore ~count make);
  { leaves; eye = made.(0); lights = Array.sub made 1 (count - 1) }

let with_fans ?(domains = 1) ?eye ~lights = function
  | Brute_force _ as index -> index
  | Hierarchy ({ shapes; bvh; _ } as h) ->
      let leaves =
        Fan_leaves.make shapes ~numbers:(Bvh.numbers bvh)
          ~balls:(Bvh.spheres bvh)
      in
      let fans = make_fans ~domains ~eye ~lights leaves in
      Hierarchy { h with fans = Some fans }

(* {1 Questions} *)

let nearest { endless; bvh; fans; _ } walk ray meeting =
  Meeting.clear meeting;
  Endless.offer endless ray meeting;
  match fans with
  | Some { eye = Some fan; leaves; _ } when Fan.has_ray_from fan ray ->
      Fan.nearest fan leaves ray meeting
  | _ -> Bvh.nearest bvh walk ray meeting

let fan_of fans series =
  if series >= 1 && series <= Array.length fans.lights then
    fans.lights.(series - 1)
  else None

let some_bounded { bvh; fans; _ } walk series ray meeting =
  match fans with
  | None -> Bvh.some bvh walk ray meeting
  | Some fans -> (
      match fan_of fans series with
      | Some fan when Fan.has_ray_to fan ray ->
          Fan.some fan fans.leaves ray meeting
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

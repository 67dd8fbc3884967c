open Raylab_geometry
open Raylab_scene

type primitive = {
  index : int;
  object_ : Object.t;
  place : Provenance.t option;
  is_taken_away : bool;
}

type past = { number : int; object_ : Object.t; place : Provenance.t option }

type crossed = {
  by : int;
  object_ : Object.t;
  primitive : primitive option;
  place : Provenance.t option;
  t : float;
  point : Vec3.t;
  part : Color.t;
}

type verdict =
  | Faces_away of { cosine : float }
  | Outside of { angle : float }
  | Blocked of {
      shadow_ray : Ray.t;
      by : int;
      blocker : Object.t;
      primitive : primitive option;
      place : Provenance.t option;
      t : float;
      point : Vec3.t;
    }
  | Lit of {
      shadow_ray : Ray.t option;
      cosine : float;
      falloff : float;
      cone : Event.cone option;
      contribution : Color.t;
      shines : Color.t list;
      past : past option;
      through : crossed list;
    }
  | Mean of {
      points : verdict list;
      contribution : Color.t;
      shines : Color.t list;
    }

type light = {
  number : int;
  light : Light.t;
  place : Provenance.t option;
  verdict : verdict;
}

type t = {
  role : Event.role;
  ray : Ray.t;
  left : int;
  outcome : outcome;
  terms : term list;
  color : Color.t;
}

and outcome = Chain_ended | Too_faint | Missed | Hit of surface_hit

and surface_hit = {
  hit : Hit.t;
  object_ : Object.t;
  primitive : primitive option;
  place : Provenance.t option;
  surface : Surface.t;
  lobes : Lobes.t;
  lights : light list;
}

and term = { source : Event.source; color : Color.t; ray : t option }

(* {1 From events to a tree} *)

(* A ray that is open: all that has been told of it, lists backwards. *)
type open_ray = {
  opened : Event.role * Ray.t * int;
  met : Hit.t option;
  shadow_ray : Ray.t option; (* whose answer is still to come *)
  points : verdict list; (* of an area light that is still to be told *)
  verdicts : light list;
  closed : t list; (* the rays that were opened in this one *)
}

let unexpected () = invalid_arg "Explain: events in a wrong order"
let place scene origin = Scene.provenance scene.Prepared.scene origin

let primitive_of scene (o : Object.t) index =
  let object_ = Object.primitive o (Some index) in
  let is_taken_away =
    match o.shape with Solid s -> s.flipped.(index - 1) | _ -> false
  in
  { index; object_; place = place scene object_.origin; is_taken_away }

let hit_of scene hit lights =
  let object_ = Prepared.numbered_object scene hit.Hit.number in
  let primitive = Option.map (primitive_of scene object_) hit.primitive in
  let { Object.surface; _ } = Object.primitive object_ hit.primitive in
  let lobes = Surface.lobes ~at:hit.own_point surface
  and surface = Surface.at surface hit.own_point in
  let place = place scene object_.origin and lights = List.rev lights in
  { hit; object_; primitive; place; surface; lobes; lights }

(* Each term that needs a ray takes the next of those that were closed. *)
let terms_of terms closed =
  let term closed { Event.source; color } =
    match (Event.sends source, closed) with
    | Some _, ray :: closed -> (closed, { source; color; ray = Some ray })
    | _ -> (closed, { source; color; ray = None })
  in
  snd (List.fold_left_map term (List.rev closed) terms)

let close scene { opened = role, ray, left; met; verdicts; closed; _ } terms
    color =
  let outcome =
    match met with
    | Some hit -> Hit (hit_of scene hit verdicts)
    | None when left = 0 -> Chain_ended
    | None when Ray.share ray < Bounces.least_share -> Too_faint
    | None -> Missed
  in
  { role; ray; left; outcome; terms = terms_of terms closed; color }

let past_of scene number =
  let object_ = Prepared.numbered_object scene number in
  { number; object_; place = place scene object_.origin }

let crossed_of scene { Event.met = { by; primitive; t; point }; part } =
  let object_ = Prepared.numbered_object scene by in
  let primitive = Option.map (primitive_of scene object_) primitive in
  let place = place scene object_.origin in
  { by; object_; primitive; place; t; point; part }

let add_verdict scene state number verdict =
  let light = Prepared.numbered_light scene number in
  let told = { number; light; place = place scene light.origin; verdict } in
  let verdicts = told :: state.verdicts in
  { state with shadow_ray = None; points = []; verdicts }

let add_point scene state number cell verdict =
  match cell with
  | None -> add_verdict scene state number verdict
  | Some _ ->
      { state with shadow_ray = None; points = verdict :: state.points }

(* [after scene state event] is [state] after an event that neither opens nor
   closes a ray. *)
let after scene state : Event.t -> open_ray = function
  | Met hit -> { state with met = Some hit }
  | Faces_away { light; cell; cosine } ->
      add_point scene state light cell (Faces_away { cosine })
  | Outside { light; angle } ->
      add_verdict scene state light (Outside { angle })
  | Shadow_ray { ray; _ } -> { state with shadow_ray = Some ray }
  | Blocked { light; cell; by; primitive; t; point } ->
      let shadow_ray = Option.get state.shadow_ray
      and blocker = Prepared.numbered_object scene by in
      add_point scene state light cell
        (let place = place scene blocker.origin in
         let primitive = Option.map (primitive_of scene blocker) primitive in
         Blocked { shadow_ray; by; blocker; primitive; place; t; point })
  | Lit
      {
        light;
        cell;
        cosine;
        falloff;
        cone;
        contribution;
        shines;
        past;
        through;
      } ->
      let shadow_ray = state.shadow_ray
      and past = Option.map (past_of scene) past
      and through = List.map (crossed_of scene) through in
      add_point scene state light cell
        (Lit
           {
             shadow_ray;
             cosine;
             falloff;
             cone;
             contribution;
             shines;
             past;
             through;
           })
  | Mean { light; contribution; shines; _ } ->
      let points = List.rev state.points in
      add_verdict scene state light (Mean { points; contribution; shines })
  | Opened _ | Closed _ | Done _ -> unexpected ()

let start role ray left =
  {
    opened = (role, ray, left);
    met = None;
    shadow_ray = None;
    points = [];
    verdicts = [];
    closed = [];
  }

(* The rays that are open, the innermost first, and the root once it is
   closed. A loop: chains may be long. *)
let step scene (open_rays, root) (event : Event.t) =
  match (event, open_rays) with
  | Opened { role; ray; left }, _ -> (start role ray left :: open_rays, root)
  | Closed { terms; color; _ }, state :: outer -> (
      let e = close scene state terms color in
      match outer with
      | [] -> ([], Some e)
      | around :: outer ->
          ({ around with closed = e :: around.closed } :: outer, root))
  | Done _, [] -> ([], root)
  | event, state :: outer -> (after scene state event :: outer, root)
  | _, [] -> unexpected ()

let events scene r =
  let told = ref [] in
  let observe event = told := event :: !told in
  ignore (Evaluator.color (Evaluator.create ~observe scene) r : Color.t);
  List.rev !told

let ray scene r =
  match List.fold_left (step scene) ([], None) (events scene r) with
  | [], Some e -> e
  | _ -> unexpected ()

let steps scene r () = List.to_seq (events scene r) ()

(* {1 Reading} *)

let tint through =
  let weaken tint { part; _ } = Saturate.color (Color.multiply tint part) in
  List.fold_left weaken Color.white through

let next e = List.filter_map (fun (term : term) -> term.ray) e.terms

let sum_of holds e =
  let add sum (term : term) =
    if holds term.source then Color.add sum term.color else sum
  in
  List.fold_left add Color.black e.terms

let light e =
  let light (term : term) =
    match term.source with
    | Diffused { light; _ } -> Some light
    | Background | Emitted | Shine _ | Mirror _ | Refraction _ -> None
  in
  Option.value (List.find_map light e.terms) ~default:Color.black

let ambient e =
  let ambient (term : term) =
    match term.source with
    | Diffused { ambient; _ } -> Some ambient
    | Background | Emitted | Shine _ | Mirror _ | Refraction _ -> None
  in
  Option.value (List.find_map ambient e.terms) ~default:Color.black

(* {1 Pixels} *)

type sample = { color : Color.t; ray : t }

type pixel = {
  x : int;
  y : int;
  film : Film.t;
  samples : sample list;
  cause : Centres.neighbour option;
  color : Color.t;
}

let pixel prepared ~x ~y =
  let scene = prepared.Prepared.scene in
  let { Scene.film; _ } = scene and sampler = Sampler.create prepared in
  let color = Sampler.lone_pixel sampler ~x ~y in
  let sample k =
    let ray = ray prepared (Sample_ray.make scene ~x ~y k) in
    { color = Film.expose film ray.color; ray }
  in
  let samples = List.init (Sampler.taken sampler) sample in
  { x; y; film; samples; cause = Sampler.cause sampler ~x ~y; color }

let centre pixel = (List.hd pixel.samples).ray

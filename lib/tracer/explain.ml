open Raylab_geometry
open Raylab_scene

type verdict =
  | Faces_away of { cosine : float }
  | Blocked of {
      shadow_ray : Ray.t;
      by : int;
      blocker : Object.t;
      t : float;
      point : Vec3.t;
    }
  | Lit of {
      shadow_ray : Ray.t option;
      cosine : float;
      falloff : float;
      contribution : Color.t;
    }

type light = { number : int; light : Light.t; verdict : verdict }

type t = { ray : Ray.t; left : int; outcome : outcome; color : Color.t }
and outcome = Chain_ended | Missed | Hit of surface_hit

and surface_hit = {
  hit : Hit.t;
  object_ : Object.t;
  surface : Surface.t;
  meaning : Surface.meaning;
  lights : light list;
  light : Color.t;
  emitted : Color.t;
  diffused : Color.t;
  mirrored : Color.t;
  reflection : t option;
}

let events scene evaluate =
  let told = ref [] in
  let observe event = told := event :: !told in
  ignore (evaluate (Trace.evaluator ~observe scene) : Color.t);
  List.rev !told

(* {1 From events to a tree}

   Each function takes the events from some place on, and gives what they tell
   and the events after that. *)

let unexpected () = invalid_arg "Explain: events in a wrong order"

(* There may be a million lights: no stack as deep. *)
let rec read_lights scene read (events : Event.t list) =
  let light number verdict rest =
    let light = Trace.numbered_light scene number in
    read_lights scene ({ number; light; verdict } :: read) rest
  in
  match events with
  | Faces_away { light = k; cosine } :: rest ->
      light k (Faces_away { cosine }) rest
  | Shadow_ray { light = k; ray } :: Blocked { by; t; point; _ } :: rest ->
      let blocker = Trace.numbered_object scene by in
      light k (Blocked { shadow_ray = ray; by; blocker; t; point }) rest
  | Shadow_ray { light = k; ray }
    :: Lit { cosine; falloff; contribution; _ }
    :: rest ->
      light k
        (Lit { shadow_ray = Some ray; cosine; falloff; contribution })
        rest
  | Lit { light = k; cosine; falloff; contribution } :: rest ->
      light k (Lit { shadow_ray = None; cosine; falloff; contribution }) rest
  | _ -> (List.rev read, events)

let rec read_ray scene ray left (events : Event.t list) =
  match events with
  | Chain_ended color :: rest ->
      ({ ray; left; outcome = Chain_ended; color }, rest)
  | Missed color :: rest -> ({ ray; left; outcome = Missed; color }, rest)
  | Nearest_hit hit :: rest -> (
      let lights, rest = read_lights scene [] rest in
      let reflection, rest = read_reflection scene rest in
      match (rest : Event.t list) with
      | Mixed { emitted; light; diffused; mirrored; color } :: rest ->
          let object_ = Trace.numbered_object scene hit.number in
          let surface = Surface.at object_.surface hit.point in
          let meaning = Surface.meaning surface in
          let outcome =
            Hit
              {
                hit;
                object_;
                surface;
                meaning;
                lights;
                light;
                emitted;
                diffused;
                mirrored;
                reflection;
              }
          in
          ({ ray; left; outcome; color }, rest)
      | _ -> unexpected ())
  | _ -> unexpected ()

and read_reflection scene : Event.t list -> _ = function
  | Bounce { ray; left } :: rest ->
      let reflection, rest = read_ray scene ray left rest in
      (Some reflection, rest)
  | events -> (None, events)

let read scene (events : Event.t list) =
  match events with
  | Cast { ray; left } :: rest -> fst (read_ray scene ray left rest)
  | _ -> unexpected ()

let ray scene r = read scene (events scene (fun e -> Evaluator.ray e r))

let pixel scene ~x ~y =
  read scene (events scene (fun e -> Evaluator.pixel e ~x ~y))

let steps scene r () =
  List.to_seq (events scene (fun e -> Evaluator.ray e r)) ()

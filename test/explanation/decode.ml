open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Raylab_explanation
open Decode_scene

(* {1 Rays} *)

let bare_ray get =
  let origin = vector (get "origin") and d = direction (get "direction") in
  let raw = Raw_ray.create () in
  let { Vec3.x; y; z } = (d :> Vec3.t) in
  Raw_ray.set_origin raw origin.x origin.y origin.z;
  Raw_ray.set_direction raw x y z;
  raw.reach <- Option.value (optional float (get "reach")) ~default:infinity;
  raw.seed <- float (get "seed");
  Ray.of_raw raw

let ray_members = [ "origin"; "direction"; "reach"; "seed" ]
let shadow_ray json = bare_ray (members ray_members json)

let light json : Explain.light =
  let is_directional = kind json = "directional" in
  let place = if is_directional then "direction" else "position" in
  let base =
    ("number" :: place_members json)
    @ [ "kind"; place; "intensity"; "color"; "verdict" ]
  in
  let get rest = members (base @ rest) json in
  let verdict, get =
    match text (member "verdict" json) with
    | "faces away" ->
        let get = get [ "cosine" ] in
        (Explain.Faces_away { cosine = float (get "cosine") }, get)
    | "blocked" ->
        let by, blocker, place = object_ (member "by" json) in
        let names, primitive = primitive json blocker in
        let get = get ([ "shadow_ray"; "by" ] @ names @ [ "t"; "point" ]) in
        let shadow_ray = shadow_ray (get "shadow_ray") in
        let point = vector (get "point") in
        let t = float (get "t") in
        (Blocked { shadow_ray; by; blocker; primitive; place; t; point }, get)
    | "lit" ->
        let names = if has "past" json then [ "past" ] else [] in
        let get =
          get ([ "shadow_ray"; "cosine"; "falloff"; "contribution" ] @ names)
        in
        let past =
          if names = [] then None
          else
            let number, object_, place = object_ (get "past") in
            Some { Explain.number; object_; place }
        in
        let shadow_ray = optional shadow_ray (get "shadow_ray") in
        let cosine = float (get "cosine")
        and falloff = float (get "falloff")
        and contribution = color (get "contribution") in
        (Lit { shadow_ray; cosine; falloff; contribution; past }, get)
    | other -> wrong other
  in
  let light =
    let intensity = float (get "intensity")
    and color = color (get "color")
    and place = vector (get place) in
    Light.with_origin (origin json)
      (if is_directional then
         Light.directional ~intensity ~color ~direction:place
       else Light.spherical ~intensity ~color ~position:place)
  in
  let place = Test_support.Build.place light.origin in
  { number = int (get "number"); light; place; verdict }

let rec ray role json : Explain.t =
  let names = ray_members @ [ "left"; "color"; "outcome"; "hit"; "terms" ] in
  let get = members names json in
  let outcome : Explain.outcome =
    match (text (get "outcome"), get "hit") with
    | "chain ended", `Null -> Chain_ended
    | "missed", `Null -> Missed
    | "hit", json -> Hit (hit json)
    | other, _ -> wrong other
  in
  {
    role;
    ray = bare_ray get;
    left = int (get "left");
    outcome;
    terms = list term (get "terms");
    color = color (get "color");
  }

and term json : Explain.term =
  let name = text (member "source" json) in
  let get rest = members ("source" :: "color" :: rest) json in
  let source, get, ray =
    match name with
    | "background" -> (Event.Background, get [], None)
    | "emitted" -> (Emitted, get [], None)
    | "diffused" ->
        let get = get [ "light" ] in
        (Diffused { light = color (get "light") }, get, None)
    | "mirrored" ->
        let get = get [ "ray" ] in
        (Mirror, get, optional (ray Mirrored) (get "ray"))
    | other -> wrong other
  in
  { source; color = color (get "color"); ray }

and hit json : Explain.surface_hit =
  let number, object_, place = object_ (member "object" json) in
  let primitive_names, primitive = primitive json object_ in
  let here =
    match json with
    | `Assoc members when List.mem_assoc "here" members -> [ "here" ]
    | _ -> []
  in
  let names =
    (("object" :: primitive_names) @ here)
    @ [ "t"; "point"; "normal"; "outside"; "part"; "own_point" ]
    @ [ "offset"; "emission"; "albedo"; "mirror"; "lights" ]
  in
  let get = members names json in
  let index = Option.map (fun p -> p.Explain.index) primitive in
  let { Object.surface; _ } = Object.primitive object_ index in
  let own_point = vector (get "own_point") in
  {
    hit =
      {
        number;
        primitive = index;
        part = int (get "part");
        t = float (get "t");
        point = vector (get "point");
        own_point;
        normal = direction (get "normal");
        outside = bool (get "outside");
        offset = float (get "offset");
      };
    object_;
    primitive;
    place;
    surface = Surface.at surface own_point;
    lobes =
      {
        emission = color (get "emission");
        albedo = color (get "albedo");
        mirror = color (get "mirror");
        highlights = [];
        refractions = [];
      };
    lights = list light (get "lights");
  }

(* {1 Documents} *)

type pixel = {
  rgb : int * int * int;
  summary : string;
  explanation : Explain.pixel;
}

let sample json : Explain.sample =
  let get = members [ "color"; "ray" ] json in
  { color = color (get "color"); ray = ray Primary (get "ray") }

let film json =
  let get = members [ "samples"; "exposure"; "srgb" ] json in
  Film.make
    ~samples:(int (get "samples"))
    ~exposure:(float (get "exposure"))
    ~srgb:(bool (get "srgb"))
    ()

let neighbour json : Centres.neighbour =
  let get = members [ "x"; "y"; "color" ] json in
  { x = int (get "x"); y = int (get "y"); color = color (get "color") }

let pixel json =
  let names =
    [ "x"; "y"; "rgb"; "summary"; "color"; "film"; "cause"; "samples" ]
  in
  let get = members names json in
  let rgb =
    match list int (get "rgb") with
    | [ r; g; b ] -> (r, g, b)
    | _ -> wrong "not three bytes"
  in
  {
    rgb;
    summary = text (get "summary");
    explanation =
      {
        x = int (get "x");
        y = int (get "y");
        film = film (get "film");
        cause = optional neighbour (get "cause");
        samples = list sample (get "samples");
        color = color (get "color");
      };
  }

let document json =
  let get = members [ "version"; "pixels" ] json in
  if int (get "version") <> Json.version then wrong "version";
  list pixel (get "pixels")

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
  raw

let ray_members = [ "origin"; "direction"; "reach"; "seed" ]
let shadow_ray json = Ray.of_raw (bare_ray (members ray_members json))

let sent_ray get =
  let raw = bare_ray get in
  raw.share <- float (get "share");
  Ray.of_raw raw

let crossed json : Explain.crossed =
  let by, object_, place = object_ (member "object" json) in
  let names, primitive = primitive json object_ in
  let get = members (("object" :: names) @ [ "t"; "point"; "part" ]) json in
  let t = float (get "t")
  and point = vector (get "point")
  and part = color (get "part") in
  { by; object_; primitive; place; t; point; part }

let cone json : Event.cone =
  let get = members [ "angle"; "part" ] json in
  { angle = float (get "angle"); part = float (get "part") }

(* With a way to get what stands in [base] before it. *)
let rec verdict base json =
  let get rest = members (base @ ("verdict" :: rest)) json in
  match text (member "verdict" json) with
  | "faces away" ->
      let get = get [ "cosine" ] in
      (Explain.Faces_away { cosine = float (get "cosine") }, get)
  | "outside" ->
      let get = get [ "angle" ] in
      (Outside { angle = float (get "angle") }, get)
  | "mean" ->
      let names = if has "shines" json then [ "shines" ] else [] in
      let get = get ([ "points"; "contribution" ] @ names) in
      let shines = if names = [] then [] else list color (get "shines") in
      let point json = fst (verdict [] json) in
      let points = list point (get "points")
      and contribution = color (get "contribution") in
      (Mean { points; contribution; shines }, get)
  | "blocked" ->
      let by, blocker, place = object_ (member "by" json) in
      let names, primitive = primitive json blocker in
      let get = get ([ "shadow_ray"; "by" ] @ names @ [ "t"; "point" ]) in
      let shadow_ray = shadow_ray (get "shadow_ray") in
      let point = vector (get "point") in
      let t = float (get "t") in
      (Blocked { shadow_ray; by; blocker; primitive; place; t; point }, get)
  | "lit" ->
      let names = List.filter (fun name -> has name json) [ "past"; "through" ]
      and cones = if has "cone" json then [ "cone" ] else []
      and shone = if has "shines" json then [ "shines" ] else [] in
      let get =
        get
          ([ "shadow_ray"; "cosine"; "falloff" ]
          @ cones @ [ "contribution" ] @ shone @ names)
      in
      let past =
        if not (has "past" json) then None
        else
          let number, object_, place = object_ (get "past") in
          Some { Explain.number; object_; place }
      in
      let shadow_ray = optional shadow_ray (get "shadow_ray") in
      let cosine = float (get "cosine")
      and falloff = float (get "falloff")
      and cone = if cones = [] then None else Some (cone (get "cone"))
      and contribution = color (get "contribution")
      and shines = if shone = [] then [] else list color (get "shines") in
      let through =
        if has "through" json then list crossed (get "through") else []
      in
      ( Lit
          {
            shadow_ray;
            cosine;
            falloff;
            cone;
            contribution;
            shines;
            past;
            through;
          },
        get )
  | other -> wrong other

let parameters = function
  | "directional" -> [ "direction" ]
  | "spherical" -> [ "position" ]
  | "spot" -> [ "position"; "target"; "inner"; "outer" ]
  | "area" -> [ "corner"; "edge"; "other"; "count" ]
  | other -> wrong other

let light json : Explain.light =
  let kind = kind json in
  let unfading = if has "unfading" json then [ "unfading" ] else [] in
  let base =
    ("number" :: place_members json)
    @ ("kind" :: parameters kind)
    @ [ "intensity"; "color" ] @ unfading
  in
  let verdict, get = verdict base json in
  let light =
    let intensity = float (get "intensity") and color = color (get "color") in
    let vector name = vector (get name) and float name = float (get name) in
    match kind with
    | "directional" ->
        Light.directional ~intensity ~color ~direction:(vector "direction")
    | "spherical" ->
        Light.spherical ~intensity ~color ~position:(vector "position")
    | "spot" ->
        Light.spot ~intensity ~color
          (Beam.make_exn ~position:(vector "position")
             ~target:(vector "target") ~inner:(float "inner")
             ~outer:(float "outer"))
    | _ ->
        Light.area ~intensity ~color
          (Pane.make ~corner:(vector "corner") ~edge:(vector "edge")
             ~other:(vector "other")
             ~count:(int_of_float (float "count")))
  in
  let light = if unfading = [] then light else Light.unfading light in
  let light = Light.with_origin (origin json) light in
  let place = Test_support.Build.place light.origin in
  { number = int (get "number"); light; place; verdict }

let highlight json : Lobes.highlight =
  let get = members [ "sharpness"; "color" ] json in
  { sharpness = float (get "sharpness"); shine = color (get "color") }

let refraction json : Lobes.refraction =
  let get = members [ "index"; "refractive"; "fresnel"; "glass" ] json in
  {
    index = float (get "index");
    plain = color (get "refractive");
    fresnel = color (get "fresnel");
    glass = color (get "glass");
  }

let rec ray role json : Explain.t =
  let names =
    ray_members @ [ "share"; "left"; "color"; "outcome"; "hit"; "terms" ]
  in
  let get = members names json in
  let outcome : Explain.outcome =
    match (text (get "outcome"), get "hit") with
    | "chain ended", `Null -> Chain_ended
    | "too faint", `Null -> Too_faint
    | "missed", `Null -> Missed
    | "hit", json -> Hit (hit json)
    | other, _ -> wrong other
  in
  {
    role;
    ray = sent_ray get;
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
        let ambients = if has "ambient" json then [ "ambient" ] else [] in
        let get = get ("light" :: ambients) in
        let ambient =
          if ambients = [] then Color.black else color (get "ambient")
        in
        (Diffused { ambient; light = color (get "light") }, get, None)
    | "shine" ->
        let get = get [ "sharpness"; "shine" ] in
        let sharpness = float (get "sharpness") in
        (Shine { sharpness; shine = color (get "shine") }, get, None)
    | "mirrored" ->
        let get = get [ "weight"; "ray" ] in
        let weight = color (get "weight") in
        (Mirror { weight }, get, optional (ray Mirrored) (get "ray"))
    | "refracted" ->
        let get = get [ "index"; "fresnel"; "cosine"; "weight"; "ray" ] in
        let index = float (get "index")
        and share = float (get "fresnel")
        and cosine = Option.value (optional float (get "cosine")) ~default:0.
        and weight = color (get "weight") in
        ( Refraction { index; weight; share; cosine },
          get,
          optional (ray Refracted) (get "ray") )
    | other -> wrong other
  in
  { source; color = color (get "color"); ray }

and hit json : Explain.surface_hit =
  let number, object_, place = object_ (member "object" json) in
  let primitive_names, primitive = primitive json object_ in
  let is_smooth = has "smoothed" json in
  let names =
    ("object" :: primitive_names)
    @ (if has "here" json then [ "here" ] else [])
    @ [ "t"; "point"; "normal" ]
    @ (if is_smooth then [ "smoothed" ] else [])
    @ [ "outside"; "part"; "own_point" ]
    @ [ "offset"; "emission"; "albedo"; "mirror" ]
    @ List.filter (fun name -> has name json) [ "highlights"; "refractions" ]
    @ [ "lights" ]
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
        shading =
          (if is_smooth then Some (direction (get "smoothed")) else None);
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
        highlights =
          (if has "highlights" json then list highlight (get "highlights")
           else []);
        refractions =
          (if has "refractions" json then list refraction (get "refractions")
           else []);
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

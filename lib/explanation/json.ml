open Raylab_source
open Raylab_geometry
open Raylab_expression
open Raylab_scene
open Raylab_tracer

let version = 3

let number x : Yojson.Safe.t =
  match Float.classify_float x with
  | FP_nan | FP_infinite -> `Null
  | _ -> `Float x

let numbers xs = `List (List.map number xs)
let vector { Vec3.x; y; z } = numbers [ x; y; z ]
let direction (d : Direction.t) = vector (d :> Vec3.t)
let color { Color.r; g; b } = numbers [ r; g; b ]
let optional json = function None -> `Null | Some value -> json value
let int n : Yojson.Safe.t = `Int n
let text s : Yojson.Safe.t = `String s

(* {1 Scenes} *)

let numbers_of : Parameter.t -> Yojson.Safe.t = function
  | Number x -> number x
  | Triple (x, y, z) -> numbers [ x; y; z ]
  | Text value | Word value -> text value

let parameter (name, parameter) = (name, numbers_of parameter)

let modifier modifier : Yojson.Safe.t =
  `Assoc
    (("kind", text (Change.name modifier))
    :: List.map parameter (Change.parameters modifier))

let modifiers shape =
  match Shape.modifiers shape with
  | [] -> []
  | modifiers -> [ ("modifiers", `List (List.map modifier modifiers)) ]

let shape shape : Yojson.Safe.t =
  `Assoc
    (("kind", text (Shape.name shape))
    :: List.map parameter (Shape.parameters shape))

let rec surface s : Yojson.Safe.t =
  let weighted (weight, s) =
    `Assoc
      [
        ("weight", numbers_of (Surface.weight weight)); ("surface", surface s);
      ]
  in
  let parts =
    match (s : Surface.t) with
    | Mixed { parts; _ } -> [ ("parts", `List (List.map weighted parts)) ]
    | Checker { size; even; odd; _ } ->
        [ ("size", number size); ("even", surface even); ("odd", surface odd) ]
    | Varying { pattern; _ } ->
        [
          ("text", text (Format.asprintf "%a" Surface.pp s));
          ("where", definitions pattern);
        ]
    | simple -> List.map parameter (Surface.parameters simple)
  in
  `Assoc (("kind", text (Surface.name s)) :: parts)

and definitions pattern : Yojson.Safe.t =
  let definition (name, definition) =
    let told : _ * Yojson.Safe.t =
      match (definition : Surface.t Closed.definition) with
      | Value v -> ("value", value v)
      | Defined _ as d -> ("function", text (Pattern_text.definition (name, d)))
    in
    `Assoc [ ("name", text name); told ]
  in
  `List (List.map definition pattern.Closed.definitions)

and value : Surface.t Closed.value -> Yojson.Safe.t = function
  | Number x -> number x
  | Truth truth -> `Bool truth
  | Text words -> text words
  | Vector v -> vector v
  | List elements -> `List (List.map value (Array.to_list elements))
  | Function name -> `Assoc [ ("function", text name) ]
  | Thing s -> surface s

(* {1 Where things come from} *)

let rec datum : Datum.t -> Yojson.Safe.t = function
  | Number x -> number x
  | Truth truth -> `Bool truth
  | Text words -> text words
  | Vector v -> vector v
  | List { first; count } ->
      `Assoc [ ("count", int count); ("first", `List (List.map datum first)) ]
  | Other words -> `Assoc [ ("what", text words) ]

let line = function
  | None -> [ ("line", `Null) ]
  | Some { Place.file; line } ->
      let file = Option.map (fun file -> ("file", text file)) file in
      ("line", int line) :: Option.to_list file

let step { Provenance.what; place } : Yojson.Safe.t =
  let what =
    match what with
    | Call { name; arguments } ->
        let argument (label, value) =
          `Assoc [ ("name", text label); ("value", datum value) ]
        in
        [
          ("call", text name);
          ("arguments", `List (List.map argument arguments));
        ]
    | Round { name; value } -> [ ("round", text name); ("value", datum value) ]
    | By_name name -> [ ("placed", text name) ]
  in
  `Assoc (what @ line place)

let place = function
  | None -> line None
  | Some { Provenance.place; steps = [] } -> line (Some place)
  | Some { place; steps } ->
      line (Some place) @ [ ("made", `List (List.map step steps)) ]

(* {1 Things} *)
let plain (o : Object.t) =
  [ ("shape", shape o.shape); ("surface", surface o.surface) ]
  @ modifiers o.shape

let rec parts (o : Object.t) : int Solid.tree -> Yojson.Safe.t = function
  | Member m -> `Assoc (("primitive", int (m + 1)) :: plain o.primitives.(m))
  | Combined (operation, items) ->
      `Assoc
        [
          ("kind", text (Solid.word operation));
          ("parts", `List (List.map (parts o) items));
        ]

let object_ n (o : Object.t) at : Yojson.Safe.t =
  let made_of =
    match o.shape with
    | Solid { tree; _ } -> [ ("solid", parts o tree) ]
    | _ -> plain o
  and shadowless =
    if o.is_shadowless then [ ("shadowless", `Bool true) ] else []
  in
  `Assoc ((("number", int n) :: place at) @ made_of @ shadowless)

let primitive = function
  | None -> []
  | Some { Explain.index; place = at; is_taken_away; _ } ->
      [
        ( "primitive",
          `Assoc
            ((("number", int index) :: place at)
            @ [ ("taken_away", `Bool is_taken_away) ]) );
      ]

(* {1 Rays} *)

let ray_members ray =
  let reach = Ray.reach ray in
  [
    ("origin", vector (Ray.origin ray));
    ("direction", direction (Ray.direction ray));
    ("reach", if reach = infinity then `Null else number reach);
    ("seed", number (Ray.seed ray));
  ]

let shadow_ray ray =
  ("shadow_ray", optional (fun ray -> `Assoc (ray_members ray)) ray)

let passed { Explain.number; object_ = o; place } =
  ("past", object_ number o place)

let crossed { Explain.by; object_ = o; primitive = p; place; t; point; part } :
    Yojson.Safe.t =
  `Assoc
    ((("object", object_ by o place) :: primitive p)
    @ [ ("t", number t); ("point", vector point); ("part", color part) ])

let list name json = function
  | [] -> []
  | some -> [ (name, `List (List.map json some)) ]

let cone { Event.angle; part } =
  ("cone", `Assoc [ ("angle", number angle); ("part", number part) ])

let shines = function
  | [] -> []
  | all -> [ ("shines", `List (List.map color all)) ]

let rec verdict : Explain.verdict -> (string * Yojson.Safe.t) list = function
  | Faces_away { cosine } ->
      [ ("verdict", text "faces away"); ("cosine", number cosine) ]
  | Blocked { shadow_ray = ray; by; blocker; primitive = p; place; t; point }
    ->
      [
        ("verdict", text "blocked");
        shadow_ray (Some ray);
        ("by", object_ by blocker place);
      ]
      @ primitive p
      @ [ ("t", number t); ("point", vector point) ]
  | Outside { angle } ->
      [ ("verdict", text "outside"); ("angle", number angle) ]
  | Mean { points; contribution; shines = s } ->
      [
        ("verdict", text "mean");
        ("points", `List (List.map (fun p -> `Assoc (verdict p)) points));
        ("contribution", color contribution);
      ]
      @ shines s
  | Lit
      {
        shadow_ray = ray;
        cosine;
        falloff;
        cone = c;
        contribution;
        shines = s;
        past;
        through;
      } ->
      [
        ("verdict", text "lit");
        shadow_ray ray;
        ("cosine", number cosine);
        ("falloff", number falloff);
      ]
      @ Option.to_list (Option.map cone c)
      @ [ ("contribution", color contribution) ]
      @ shines s
      @ Option.to_list (Option.map passed past)
      @ list "through" crossed through

let light { Explain.number = n; light; place = at; verdict = v } :
    Yojson.Safe.t =
  let unfading =
    if light.is_unfading then [ ("unfading", `Bool true) ] else []
  in
  `Assoc
    ((("number", int n) :: place at)
    @ ("kind", text (Light.name light))
      :: List.map parameter (Light.parameters light)
    @ [ ("intensity", number light.intensity); ("color", color light.color) ]
    @ unfading @ verdict v)

let highlight { Lobes.sharpness; shine } : Yojson.Safe.t =
  `Assoc [ ("sharpness", number sharpness); ("color", color shine) ]

let refraction { Lobes.index; plain; fresnel; glass } : Yojson.Safe.t =
  `Assoc
    [
      ("index", number index);
      ("refractive", color plain);
      ("fresnel", color fresnel);
      ("glass", color glass);
    ]

let smoothed = function
  | None -> []
  | Some normal -> [ ("smoothed", direction normal) ]

(* What a surface that varies is at the point. *)
let here (h : Explain.surface_hit) =
  let written = (Object.primitive h.object_ h.hit.primitive).surface in
  if Surface.varies written then [ ("here", surface h.surface) ] else []

let of_hit (h : Explain.surface_hit) : Yojson.Safe.t =
  `Assoc
    (("object", object_ h.hit.number h.object_ h.place)
     :: primitive h.primitive
    @ here h
    @ [
        ("t", number h.hit.t);
        ("point", vector h.hit.point);
        ("normal", direction h.hit.normal);
      ]
    @ smoothed h.hit.shading
    @ [
        ("outside", `Bool h.hit.outside);
        ("part", int h.hit.part);
        ("own_point", vector h.hit.own_point);
        ("offset", number h.hit.offset);
        ("emission", color h.lobes.emission);
        ("albedo", color h.lobes.albedo);
        ("mirror", color h.lobes.mirror);
      ]
    @ list "highlights" highlight h.lobes.highlights
    @ list "refractions" refraction h.lobes.refractions
    @ [ ("lights", `List (List.map light h.lights)) ])

let rec of_ray (e : Explain.t) : Yojson.Safe.t =
  let outcome, hit =
    match e.outcome with
    | Chain_ended -> ("chain ended", `Null)
    | Too_faint -> ("too faint", `Null)
    | Missed -> ("missed", `Null)
    | Hit h -> ("hit", of_hit h)
  in
  `Assoc
    (ray_members e.ray
    @ [
        ("share", number (Ray.share e.ray));
        ("left", int e.left);
        ("color", color e.color);
        ("outcome", text outcome);
        ("hit", hit);
        ("terms", `List (List.map of_term e.terms));
      ])

and of_term { Explain.source; color = c; ray } =
  let of_source =
    match source with
    | Background | Emitted -> []
    | Diffused { ambient; light } ->
        ("light", color light)
        ::
        (if Color.equal ambient Color.black then []
         else [ ("ambient", color ambient) ])
    | Shine { sharpness; shine } ->
        [ ("sharpness", number sharpness); ("shine", color shine) ]
    | Mirror { weight } ->
        [ ("weight", color weight); ("ray", optional of_ray ray) ]
    | Refraction { index; weight; share; cosine } ->
        [
          ("index", number index);
          ("fresnel", number share);
          ("cosine", if cosine = 0. then `Null else number cosine);
          ("weight", color weight);
          ("ray", optional of_ray ray);
        ]
  in
  `Assoc
    (("source", text (Event.source_name source))
    :: ("color", color c)
    :: of_source)

(* {1 Documents} *)

let of_sample { Explain.color = c; ray } =
  `Assoc [ ("color", color c); ("ray", of_ray ray) ]

let of_film { Film.samples; exposure; srgb } =
  `Assoc
    [
      ("samples", int samples);
      ("exposure", number exposure);
      ("srgb", `Bool srgb);
    ]

let of_neighbour { Centres.x; y; color = c } =
  `Assoc [ ("x", int x); ("y", int y); ("color", color c) ]

let of_pixel (pixel : Explain.pixel) =
  let r, g, b = Film.to_bytes pixel.film pixel.color in
  `Assoc
    [
      ("x", int pixel.x);
      ("y", int pixel.y);
      ("rgb", `List [ int r; int g; int b ]);
      ("summary", text (Summary.of_pixel pixel));
      ("color", color pixel.color);
      ("film", of_film pixel.film);
      ("cause", optional of_neighbour pixel.cause);
      ("samples", `List (List.map of_sample pixel.samples));
    ]

let document pixels =
  `Assoc
    [ ("version", int version); ("pixels", `List (List.map of_pixel pixels)) ]

let rec depth (json : Yojson.Safe.t) =
  let deepest = List.fold_left (fun d json -> Int.max d (depth json)) 0 in
  match json with
  | `Assoc members -> 1 + deepest (List.map snd members)
  | `List items -> 1 + deepest items
  | _ -> 0

(* A hundred rays. Far beyond that there would be little but indentation. *)
let deepest_laid_out = 200

let to_string json =
  let text =
    if depth json <= deepest_laid_out then
      Yojson.Safe.pretty_to_string ~std:true json
    else Yojson.Safe.to_string ~std:true json
  in
  text ^ "\n"

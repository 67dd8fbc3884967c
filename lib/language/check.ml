open Raylab_geometry
open Raylab_scene

(* {1 Finding every error} *)

let check_light words { Syntax.source; intensity; color; _ } =
  Check_words.skip_keyword words;
  Check_words.number words Non_negative "the intensity" intensity;
  Check_words.color words "the light's colour" color;
  match source with
  | Directional direction ->
      Check_words.direction words "the direction" direction
  | Spherical position ->
      Check_words.vector words "the light's position" position

let check_shape words shape =
  Check_words.skip_keyword words;
  match shape with
  | Syntax.Sphere { centre; radius } ->
      Check_words.vector words "the centre" centre;
      Check_words.number words Positive "the radius" radius
  | Plane { point; normal } ->
      Check_words.vector words "the point" point;
      Check_words.direction words "the normal" normal

let too_deep = "mixes are nested deeper than 1,000"

let rec check_surface words nesting = function
  | Syntax.Mixed _ when nesting = Surface.max_nesting ->
      Check_words.refuse words too_deep
        ~advice:
          "a mix in a mix may be written as one, with its weights multiplied"
  | surface -> (
      Check_words.skip_keyword words;
      match surface with
      | Reflective -> ()
      | Diffusive color | Luminous color ->
          Check_words.color words "the surface's colour" color
      | Mixed parts -> List.iter (check_part words (nesting + 1)) parts)

and check_part words nesting (weight, surface) =
  Check_words.number words Non_negative "the weight" weight;
  check_surface words nesting surface

let check_object words { Syntax.shape; surface; _ } =
  check_shape words shape;
  check_surface words 0 surface

(* {1 Building}

   The library checks what it is given, by the same rules; where it refuses, the
   checks above say what is wrong, and where. *)

let light { Syntax.source; intensity; color; line; _ } =
  Light.with_line (Some line)
    (match source with
    | Directional direction -> Light.directional ~intensity ~color ~direction
    | Spherical position -> Light.spherical ~intensity ~color ~position)

let shape = function
  | Syntax.Sphere { centre; radius } -> Shape.sphere ~centre ~radius
  | Plane { point; normal } -> Shape.plane ~point ~normal

let rec surface nesting = function
  | Syntax.Diffusive c -> Surface.diffusive c
  | Reflective -> Surface.reflective
  | Luminous c -> Surface.luminous c
  | Mixed _ when nesting = Surface.max_nesting -> invalid_arg too_deep
  | Mixed parts ->
      let part (weight, inner) = (weight, surface (nesting + 1) inner) in
      Surface.mixed (List.map part parts)

let object_ { Syntax.shape = s; surface = f; line; _ } =
  Object.make ~line (shape s) (surface 0 f)

(* [build_all findings build check start items] is what [build] makes of each
   item. [check] tells what is wrong with one that it refuses. *)
let build_all findings build check start items =
  let build_or_report item =
    match build item with
    | built -> Some built
    | exception Invalid_argument _ ->
        check (Check_words.start findings (start item)) item;
        None
  in
  List.filter_map build_or_report items

let scene source ({ Syntax.lights; objects; _ } as syntax) =
  let findings = Findings.start source in
  Check_header.check findings syntax;
  let lights =
    build_all findings light check_light (fun l -> l.Syntax.start) lights
  in
  let objects =
    build_all findings object_ check_object (fun o -> o.Syntax.start) objects
  in
  match Findings.errors findings with
  | [] ->
      Ok
        (Scene.make
           (Check_header.camera syntax)
           ~lights ~objects
           ?background:(Check_header.background syntax)
           ?ray_depth:(Check_header.ray_depth syntax))
  | errors -> Error errors

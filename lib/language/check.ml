open Raylab_geometry
open Raylab_scene

(* {1 Finding every error} *)

type report = {
  source : Source.t;
  mutable errors : (Span.t * Scene_error.t) list;
}

let error report span ?advice message =
  let found = Scene_error.make report.source span ?advice message in
  report.errors <- (span, found) :: report.errors

let check_value report rule name span value =
  match Number.broken rule value with
  | None -> ()
  | Some problem ->
      let found = Source.quote report.source span in
      error report span (Printf.sprintf "%s %s, not %s" name problem found)

let check_number report rule name { Syntax.value; span } =
  check_value report rule name span value

let check_parts report rule name span parts =
  List.iteri
    (fun k (part, value) ->
      let word = Source.word report.source span k in
      check_value report rule
        (Printf.sprintf "the %s of %s" part name)
        word value)
    parts

let check_vector report name { Syntax.value = { Vec3.x; y; z } as v; span } =
  (* finding the words takes time, and nearly all vectors are right *)
  if not (Vec3.is_finite v) then
    check_parts report Finite name span [ ("x", x); ("y", y); ("z", z) ]

let check_direction report name ({ Syntax.value; span } as vector) =
  check_vector report name vector;
  if Vec3.equal value Vec3.zero then
    error report span
      (name ^ " must not be the zero vector")
      ~advice:"give at least one number that is not 0, such as 0 1 0"

let check_color report name { Syntax.value = { Color.r; g; b }; span } =
  let right v = Number.broken Non_negative v = None in
  if not (right r && right g && right b) then
    check_parts report Non_negative name span
      [ ("red", r); ("green", g); ("blue", b) ]

let check_light report { Syntax.source; intensity; color; _ } =
  check_number report Non_negative "the intensity" intensity;
  check_color report "the light's colour" color;
  match source with
  | Directional direction -> check_direction report "the direction" direction
  | Point position -> check_vector report "the light's position" position

let check_shape report = function
  | Syntax.Sphere { centre; radius } ->
      check_vector report "the centre" centre;
      check_number report Positive "the radius" radius
  | Plane { point; normal } ->
      check_vector report "the point" point;
      check_direction report "the normal" normal

let rec check_surface report = function
  | Syntax.Reflective -> ()
  | Diffusive color | Luminous color ->
      check_color report "the surface's colour" color
  | Mixed parts ->
      List.iter
        (fun (weight, surface) ->
          check_number report Non_negative "the weight" weight;
          check_surface report surface)
        parts

let check_object report { Syntax.shape; surface; _ } =
  check_shape report shape;
  check_surface report surface

(* {1 The header} *)

let keyword = function
  | Syntax.Image_width _ -> "imWidth"
  | Image_height _ -> "imHeight"
  | Canvas_width _ -> "canvWidth"
  | Canvas_height _ -> "canvHeight"
  | Depth _ -> "depth"
  | Background _ -> "bcolor"
  | Ray_depth _ -> "raydepth"

let required = [ "imWidth"; "imHeight"; "canvWidth"; "canvHeight"; "depth" ]

let check_whole report name ~least ~most { Syntax.value; span } =
  let text = Source.slice report.source span in
  let is_digit c = '0' <= c && c <= '9' in
  let digits =
    match text.[0] with
    | '+' | '-' -> String.sub text 1 (String.length text - 1)
    | _ -> text
  in
  let number = Printf.sprintf "a whole number from %d to %d" least most in
  if
    not
      (String.for_all is_digit digits
      && value >= float_of_int least
      && value <= float_of_int most)
  then
    error report span
      (Printf.sprintf "%s must be %s, not %s" name number
         (Source.quote report.source span))

let check_setting report = function
  | Syntax.Image_width n ->
      check_whole report "imWidth" ~least:1 ~most:Camera.max_size n
  | Image_height n ->
      check_whole report "imHeight" ~least:1 ~most:Camera.max_size n
  | Canvas_width n -> check_number report Positive "canvWidth" n
  | Canvas_height n -> check_number report Positive "canvHeight" n
  | Depth n -> check_number report Positive "depth" n
  | Ray_depth n ->
      check_whole report "raydepth" ~least:0 ~most:Scene.max_ray_depth n
  | Background c -> check_color report "bcolor" c

let check_header report { Syntax.header; header_end; _ } =
  let check seen (span, setting) =
    check_setting report setting;
    let name = keyword setting in
    (match List.assoc_opt name seen with
    | Some first ->
        let { Source.line; _ } = Source.place report.source first in
        error report span
          (Printf.sprintf "%s is set a second time" name)
          ~advice:
            (Printf.sprintf "it is already set in line %d; remove one of them"
               line)
    | None -> ());
    (name, span) :: seen
  in
  let seen = List.fold_left check [] header in
  let missing =
    List.filter (fun name -> not (List.mem_assoc name seen)) required
  in
  if missing <> [] then
    error report header_end
      (Printf.sprintf "the header lacks %s" (String.concat ", " missing))
      ~advice:
        "every scene starts with imWidth, imHeight, canvWidth, canvHeight and \
         depth, each followed by a number"

let errors source (syntax : Syntax.t) =
  let report = { source; errors = [] } in
  check_header report syntax;
  List.iter (check_light report) syntax.lights;
  List.iter (check_object report) syntax.objects;
  let by_start (a, _) (b, _) = Int.compare (Span.start a) (Span.start b) in
  List.map snd (List.stable_sort by_start (List.rev report.errors))

(* {1 Building a scene in which no error was found} *)

let light { Syntax.source; intensity; color; line } =
  let intensity = intensity.value and color = color.value in
  match source with
  | Directional d -> Light.directional ~line ~intensity ~color d.value
  | Point p -> Light.point ~line ~intensity ~color p.value

let shape = function
  | Syntax.Sphere { centre; radius } ->
      Shape.sphere ~centre:centre.value ~radius:radius.value
  | Plane { point; normal } ->
      Shape.plane ~point:point.value ~normal:normal.value

let rec surface = function
  | Syntax.Diffusive c -> Surface.diffusive c.value
  | Reflective -> Surface.reflective
  | Luminous c -> Surface.luminous c.value
  | Mixed parts ->
      let part ({ Syntax.value; _ }, s) = (value, surface s) in
      Surface.mixed (List.map part parts)

let object_ { Syntax.shape = s; surface = f; line } =
  Object.make ~line (shape s) (surface f)

let build { Syntax.header; lights; objects; _ } =
  let find choose = List.find_map (fun (_, setting) -> choose setting) header in
  (* [check_header] saw to it that the required settings are there *)
  let number choose = (Option.get (find choose) : Syntax.number).value in
  let whole choose = int_of_float (number choose) in
  let camera =
    Camera.make
      ~width:(whole (function Image_width n -> Some n | _ -> None))
      ~height:(whole (function Image_height n -> Some n | _ -> None))
      ~canvas_width:(number (function Canvas_width n -> Some n | _ -> None))
      ~canvas_height:(number (function Canvas_height n -> Some n | _ -> None))
      ~depth:(number (function Depth n -> Some n | _ -> None))
  in
  Scene.make camera
    ?background:(find (function Background c -> Some c.value | _ -> None))
    ?ray_depth:
      (find (function Ray_depth n -> Some (int_of_float n.value) | _ -> None))
    ~lights:(List.map light lights) ~objects:(List.map object_ objects)

let scene source syntax =
  match errors source syntax with
  | [] -> Ok (build syntax)
  | errors -> Error errors

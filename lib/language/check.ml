open Raylab_geometry
open Raylab_scene

(* {1 Finding every error} *)

type report = {
  source : Source.t;
  mutable errors : (Span.t * Scene_error.t) list;
  mutable count : int;
  mutable first_untold : Span.t option;
}

(* More help nobody, and a hostile file has as many as would fill memory. *)
let most_errors = 100_000

let error report span ?advice message =
  report.count <- report.count + 1;
  if report.count <= most_errors then
    let found = Scene_error.make report.source span ?advice message in
    report.errors <- (span, found) :: report.errors
  else if report.first_untold = None then report.first_untold <- Some span

let check_value report rule name span value =
  match Number.broken rule value with
  | None -> ()
  | Some problem ->
      let found = Source.quote report.source span in
      error report span (Printf.sprintf "%s %s, not %s" name problem found)

let check_number report rule name { Syntax.value; span } =
  check_value report rule name span value

(* {1 The words of a light or an object}

   Each check takes the words that it is about, one after another. *)

type words = { report : report; mutable offset : int }

let peek words = Source.next_word words.report.source words.offset

let next words =
  let span = peek words in
  words.offset <- Span.stop span;
  span

let skip_keyword words = ignore (next words : Span.t)

let check_next words rule name value =
  check_value words.report rule name (next words) value

let check_part words rule name part value =
  check_next words rule (Printf.sprintf "the %s of %s" part name) value

let check_vector words name { Vec3.x; y; z } =
  check_part words Finite name "x" x;
  check_part words Finite name "y" y;
  check_part words Finite name "z" z

let check_direction words name vector =
  let start = Span.start (peek words) in
  check_vector words name vector;
  if Vec3.equal vector Vec3.zero then
    error words.report
      (Span.make ~start ~stop:words.offset)
      (name ^ " must not be the zero vector")
      ~advice:"give at least one number that is not 0, such as 0 1 0"

let check_color words name { Color.r; g; b } =
  match Keyword.token (Source.slice words.report.source (peek words)) with
  | Some (COLOR _) -> skip_keyword words
  | _ ->
      check_part words Non_negative name "red" r;
      check_part words Non_negative name "green" g;
      check_part words Non_negative name "blue" b

let check_light words { Syntax.source; intensity; color; _ } =
  skip_keyword words;
  check_next words Non_negative "the intensity" intensity;
  check_color words "the light's colour" color;
  match source with
  | Directional direction -> check_direction words "the direction" direction
  | Point position -> check_vector words "the light's position" position

let check_shape words shape =
  skip_keyword words;
  match shape with
  | Syntax.Sphere { centre; radius } ->
      check_vector words "the centre" centre;
      check_next words Positive "the radius" radius
  | Plane { point; normal } ->
      check_vector words "the point" point;
      check_direction words "the normal" normal

let rec check_surface words surface =
  skip_keyword words;
  match surface with
  | Syntax.Reflective -> ()
  | Diffusive color | Luminous color ->
      check_color words "the surface's colour" color
  | Mixed parts -> check_mix words parts

(* The last part, which may be a mix of a million mixes, by a tail call. *)
and check_mix words = function
  | [] -> ()
  | (weight, surface) :: rest ->
      check_next words Non_negative "the weight" weight;
      if rest = [] then check_surface words surface
      else (
        check_surface words surface;
        check_mix words rest)

let check_object words { Syntax.shape; surface; _ } =
  check_shape words shape;
  check_surface words surface

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

let check_setting report (keyword : Span.t) = function
  | Syntax.Image_width n ->
      check_whole report "imWidth" ~least:1 ~most:Camera.max_size n
  | Image_height n ->
      check_whole report "imHeight" ~least:1 ~most:Camera.max_size n
  | Canvas_width n -> check_number report Positive "canvWidth" n
  | Canvas_height n -> check_number report Positive "canvHeight" n
  | Depth n -> check_number report Positive "depth" n
  | Ray_depth n ->
      check_whole report "raydepth" ~least:0 ~most:Scene.max_ray_depth n
  | Background c ->
      check_color { report; offset = Span.stop keyword } "bcolor" c

let check_header report header header_end =
  let check seen (span, setting) =
    check_setting report span setting;
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

(* {1 Building}

   The library checks what it is given, by the same rules; where it refuses, the
   checks above say what is wrong, and where. *)

let light { Syntax.source; intensity; color; line; _ } =
  match source with
  | Directional direction -> Light.directional ~line ~intensity ~color direction
  | Point position -> Light.point ~line ~intensity ~color position

let shape = function
  | Syntax.Sphere { centre; radius } -> Shape.sphere ~centre ~radius
  | Plane { point; normal } -> Shape.plane ~point ~normal

(* [enclose inner mixes] is [inner] in all of [mixes], the innermost first: each
   is its parts before, the last of them first, and the weight of what is in it.
*)
let enclose =
  List.fold_left (fun inner (before, weight) ->
      Surface.mixed (List.rev ((weight, inner) :: before)))

(* Only the last part of a mix is a mix, which may go on a million deep: down
   that chain and up again by loops. *)
let rec surface_in mixes = function
  | Syntax.Diffusive c -> enclose (Surface.diffusive c) mixes
  | Reflective -> enclose Surface.reflective mixes
  | Luminous c -> enclose (Surface.luminous c) mixes
  | Mixed parts -> mix_in mixes [] parts

and mix_in mixes before = function
  | [ (weight, last) ] -> surface_in ((before, weight) :: mixes) last
  | (weight, surface) :: rest ->
      mix_in mixes ((weight, surface_in [] surface) :: before) rest
  | [] -> invalid_arg "a mix of no surfaces"

let surface = surface_in []

let object_ { Syntax.shape = s; surface = f; line; _ } =
  Object.make ~line (shape s) (surface f)

(* [build_all report build check start items] is what [build] makes of each item.
   One that it refuses is reported. *)
let build_all report build check start items =
  let build_or_report item =
    match build item with
    | built -> Some built
    | exception Invalid_argument _ ->
        check { report; offset = start item } item;
        None
  in
  List.filter_map build_or_report items

let camera header =
  let find choose = List.find_map (fun (_, setting) -> choose setting) header in
  (* [check_header] saw to it that these are there *)
  let number choose = (Option.get (find choose)).Syntax.value in
  let whole choose = int_of_float (number choose) in
  Camera.make
    ~width:(whole (function Syntax.Image_width n -> Some n | _ -> None))
    ~height:(whole (function Syntax.Image_height n -> Some n | _ -> None))
    ~canvas_width:
      (number (function Syntax.Canvas_width n -> Some n | _ -> None))
    ~canvas_height:
      (number (function Syntax.Canvas_height n -> Some n | _ -> None))
    ~depth:(number (function Syntax.Depth n -> Some n | _ -> None))

let build_scene header lights objects =
  let find choose = List.find_map (fun (_, setting) -> choose setting) header in
  Scene.make (camera header) ~lights ~objects
    ?background:(find (function Syntax.Background c -> Some c | _ -> None))
    ?ray_depth:
      (find (function
        | Syntax.Ray_depth n -> Some (int_of_float n.value)
        | _ -> None))

let in_order errors =
  let by_start (a, _) (b, _) = Int.compare (Span.start a) (Span.start b) in
  List.map snd (List.stable_sort by_start (List.rev errors))

let untold report =
  let tell span =
    let more = report.count - most_errors in
    Scene_error.make report.source span
      (Printf.sprintf "%d more error%s, the first of them here" more
         (if more = 1 then "" else "s"))
  in
  Option.to_list (Option.map tell report.first_untold)

let scene source { Syntax.header; header_end; lights; objects } =
  let report = { source; errors = []; count = 0; first_untold = None } in
  check_header report header header_end;
  let lights =
    build_all report light check_light (fun l -> l.Syntax.start) lights
  in
  let objects =
    build_all report object_ check_object (fun o -> o.Syntax.start) objects
  in
  match report.errors with
  | [] -> Ok (build_scene header lights objects)
  | errors -> Error (in_order errors @ untold report)

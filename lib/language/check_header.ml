open Raylab_scene

(* {1 Finding every error} *)

let check_number findings rule name { Syntax.value; span } =
  Findings.check_value findings rule name span value

let keyword = function
  | Syntax.Image_width _ -> "imWidth"
  | Image_height _ -> "imHeight"
  | Canvas_width _ -> "canvWidth"
  | Canvas_height _ -> "canvHeight"
  | Depth _ -> "depth"
  | Background _ -> "bcolor"
  | Ray_depth _ -> "raydepth"

let required = [ "imWidth"; "imHeight"; "canvWidth"; "canvHeight"; "depth" ]

let check_whole findings name ~least ~most { Syntax.value; span } =
  let source = Findings.source findings in
  let text = Source.slice source span in
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
    Findings.error findings span
      (Printf.sprintf "%s must be %s, not %s" name number
         (Source.quote source span))

let check_setting findings (keyword : Span.t) = function
  | Syntax.Image_width n ->
      check_whole findings "imWidth" ~least:1 ~most:Camera.max_size n
  | Image_height n ->
      check_whole findings "imHeight" ~least:1 ~most:Camera.max_size n
  | Canvas_width n -> check_number findings Positive "canvWidth" n
  | Canvas_height n -> check_number findings Positive "canvHeight" n
  | Depth n -> check_number findings Positive "depth" n
  | Ray_depth n ->
      check_whole findings "raydepth" ~least:0 ~most:Scene.max_ray_depth n
  | Background c ->
      Check_words.(color (start findings (Span.stop keyword)) "bcolor" c)

let check findings { Syntax.header; header_end; _ } =
  let check_one seen (span, setting) =
    check_setting findings span setting;
    let name = keyword setting in
    (match List.assoc_opt name seen with
    | Some first ->
        let place = Source.place (Findings.source findings) first in
        Findings.error findings span
          (Printf.sprintf "%s is set a second time" name)
          ~advice:
            (Printf.sprintf "it is already set in line %d; remove one of them"
               place.line)
    | None -> ());
    (name, span) :: seen
  in
  let seen = List.fold_left check_one [] header in
  let missing =
    List.filter (fun name -> not (List.mem_assoc name seen)) required
  in
  if missing <> [] then
    Findings.error findings header_end
      (Printf.sprintf "the header lacks %s" (String.concat ", " missing))
      ~advice:
        "every scene starts with imWidth, imHeight, canvWidth, canvHeight and \
         depth, each followed by a number"

(* {1 What it says} *)

let find choose { Syntax.header; _ } =
  List.find_map (fun (_, setting) -> choose setting) header

let camera syntax =
  (* [check] saw to it that these are there *)
  let number choose = (Option.get (find choose syntax)).Syntax.value in
  let whole choose = int_of_float (number choose) in
  Camera.make
    ~width:(whole (function Syntax.Image_width n -> Some n | _ -> None))
    ~height:(whole (function Syntax.Image_height n -> Some n | _ -> None))
    ~canvas_width:
      (number (function Syntax.Canvas_width n -> Some n | _ -> None))
    ~canvas_height:
      (number (function Syntax.Canvas_height n -> Some n | _ -> None))
    ~depth:(number (function Syntax.Depth n -> Some n | _ -> None))

let background = find (function Syntax.Background c -> Some c | _ -> None)

let ray_depth =
  find (function
    | Syntax.Ray_depth n -> Some (int_of_float n.value)
    | _ -> None)

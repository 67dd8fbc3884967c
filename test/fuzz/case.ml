type kind = string * (Random.State.t -> string)

let choose random items = items.(Random.State.int random (Array.length items))
let up_to random n = Random.State.int random (n + 1)
let one_in random n = Random.State.int random n = 0

(* [some random n item] is up to [n] items, joined. *)
let some random n item =
  String.concat " " (List.init (up_to random n) (fun _ -> item random))

(* {1 Bytes and words} *)

let any_byte random = Char.chr (Random.State.int random 256)
let bytes random = String.init (up_to random 80) (fun _ -> any_byte random)

let keywords =
  let word (word, _) = word in
  Array.of_list (List.map word Raylab_language.Keyword.all)

let strange =
  [|
    "\x00"; "\xff"; "\xc3"; "\xed\xa0\x80"; "\xf4\x90\x80\x80"; "\xef\xbb\xbf";
    "\x1b[31m"; "\x1b]0;x\x07"; "\u{202E}"; "\u{200B}"; "\u{85}"; "\x7f"; "\r";
    "\r\n"; "\n"; "\t"; "\x0b"; "#"; "# sphere\n"; "difuse"; "shpere"; "nan";
    "inf"; "-inf"; "0x10"; "1_000"; "1e"; "1e+"; "."; "-"; "+"; "--1"; "1.2.3";
    "1e400"; "-1e400"; "1e-400"; "-0"; "99999999999999999999"; "1e999999999";
    "0.00000000000000000000000000001"; "00000000000000000000000000000001";
    "2147483647"; "2147483648"; "-1"; "0"; "4e-324"; "1.7976931348623157e308";
    "1.7976931348623159e308"; "\u{A0}"; "\u{2212}1"; "\u{AD}"; "\u{201C}red";
    "1\xa02"; "1,5"; "0,0,6"; "mirror"; "light";
  |]
[@@ocamlformat "disable"]

let word random =
  match up_to random 3 with
  | 0 -> choose random strange
  | 1 -> string_of_int (up_to random 9)
  | _ -> choose random keywords

let words random = some random 40 word

(* {1 Scenes by the grammar}

   Each scene draws its numbers from one of these, since what is interesting
   about a number is often how it fits another. *)

let everyday random =
  Printf.sprintf "%.3g" (Random.State.float random 20. -. 10.)

(* The eye is at (0, 0, -1) or (0, 0, -5); much coincides. *)
let few random = choose random [| "0"; "1"; "-1"; "5"; "-5"; "2"; "-0" |]

let any_size random =
  let sign = if Random.State.bool random then "-" else "" in
  Printf.sprintf "%s%de%d" sign (up_to random 9) (up_to random 300 - 150)

let largest random =
  choose random
    [|
      "1e150"; "-1e150"; "1e-150"; "1e154"; "-1e160"; "1e200"; "1e300";
      "-1.7976931348623157e308"; "1.7976931348623157e308"; "4e-324"; "-4e-324";
      "1e-310"; "0"; "1"; "-1"; "1e-9"; "1e9"; "1e308"; "1e-5"; "1e15";
    |]
[@@ocamlformat "disable"]

let mixture random =
  (choose random [| everyday; few; any_size; largest |]) random

let without_sign text =
  if text.[0] = '-' then String.sub text 1 (String.length text - 1) else text

(* Nearly always right, so that the rest of the scene is reached. *)
let at_least_0 number random =
  let text = number random in
  if one_in random 200 then text else without_sign text

let positive number random =
  let text = at_least_0 number random in
  if float_of_string_opt text = Some 0. && not (one_in random 200) then "1"
  else text

let vector number random =
  Printf.sprintf "%s %s %s" (number random) (number random) (number random)

let direction number random =
  let text = vector number random in
  if one_in random 200 then text
  else
    Scanf.sscanf text "%f %f %f" (fun x y z ->
        if x = 0. && y = 0. && z = 0. then "0 1 0" else text)

let color number random =
  if Random.State.bool random then choose random [| "white"; "red"; "Black" |]
  else vector (at_least_0 number) random

let patterns number random =
  [|
    "diffusive [abs(p)]"; "diffusive [abs(p.x), 0.5, noise(p)]";
    Printf.sprintf "mixed (abs(p.y)) diffusive %s 0.5 reflective"
      (vector (at_least_0 number) random);
    Printf.sprintf "diffusive [1 / (p.x - %s), 1, 1] " (at_least_0 number random);
    "luminous [hsv(atan2(p.z, p.x), 0.5, 1)]";
    "checker 0.5 diffusive [p * p] reflective";
    "(if p.x > 0 then p else 1)"; "varying q diffusive [q * p]";
    "diffusive [for i = 1 to 3: turbulence(i * p, 3) + 1]";
  |]
[@@ocamlformat "disable"]

let rec surface number depth random =
  match up_to random (if depth = 0 then 4 else 7) with
  | 0 -> "diffusive " ^ color number random
  | 1 -> "reflective"
  | 2 -> "luminous " ^ color number random
  | 3 ->
      Printf.sprintf "glass %s %s" (positive number random)
        (color number random)
  | 4 ->
      Printf.sprintf "%s %s %s"
        (choose random [| "refractive"; "glossy" |])
        (positive number random) (color number random)
  | 5 ->
      Printf.sprintf "checker %s %s %s" (positive number random)
        (surface number (depth - 1) random)
        (surface number (depth - 1) random)
  | 6 -> "varying p " ^ choose random (patterns number random)
  | _ ->
      let weight random =
        match up_to random 2 with
        | 0 ->
            let channel () = at_least_0 number random in
            Printf.sprintf "[%s, %s, %s]" (channel ()) (channel ())
              (channel ())
        | _ -> at_least_0 number random
      in
      let part random =
        weight random ^ " " ^ surface number (depth - 1) random
      in
      Printf.sprintf "mixed %s %s" (part random) (some random 2 part)

let modifier number random =
  match up_to random 3 with
  | 0 -> "scaled " ^ positive number random
  | 1 -> "stretched " ^ vector (positive number) random
  | 2 ->
      Printf.sprintf "rotated %s %s" (direction number random) (number random)
  | _ -> "translated " ^ vector number random

(* Those that are in memory, and one that is not. *)
let meshes =
  [|
    {|mesh "cube.obj"|}; {|mesh "tetrahedron.obj" smooth|};
    {|mesh "roof.obj"|}; {|mesh "roof.obj" smooth|}; {|mesh "none.ply"|};
  |]
[@@ocamlformat "disable"]

let object_ number random =
  let vector _ = vector number random
  and direction _ = direction number random
  and positive _ = positive number random
  and at_least_0 _ = at_least_0 number random in
  let word, parameters =
    match up_to random 9 with
    | 0 -> ("sphere", [ vector; positive ])
    | 1 -> ("plane", [ vector; direction ])
    | 2 -> ("box", [ vector; vector ])
    | 3 -> ("cylinder", [ vector; vector; positive ])
    | 4 -> ("cone", [ vector; at_least_0; vector; at_least_0 ])
    | 5 -> ("torus", [ vector; direction; positive; positive ])
    | 6 -> ("disc", [ vector; direction; positive ])
    | 7 -> ("triangle", [ vector; vector; vector ])
    | 8 -> (choose random meshes, [])
    | _ -> ("quad", [ vector; direction; direction ])
  in
  let modifiers =
    if one_in random 3 then some random 3 (modifier number) else ""
  in
  String.concat " "
    ((word :: List.map (fun write -> write ()) parameters)
    @ [ surface number 3 random; modifiers ])
  ^ "\n"

let light number random =
  let intensity = at_least_0 number random and color = color number random in
  let place = vector number random in
  let word, parameters =
    match up_to random 5 with
    | 0 | 1 -> ("spherical", place)
    | 2 | 3 -> ("directional", direction number random)
    | 4 ->
        let target = direction number random
        and inner = choose random [| "0"; "10"; "89.9"; "179" |]
        and outer = choose random [| "10"; "90"; "179"; "180" |] in
        ("spot", String.concat " " [ place; target; inner; outer ])
    | _ ->
        let edge = vector number random and other = vector number random in
        let count = string_of_int (1 + up_to random 3) in
        ("area", String.concat " " [ place; edge; other; count ])
  in
  let unfading = if one_in random 5 then " unfading" else "" in
  Printf.sprintf "%s %s %s %s%s\n" word intensity color parameters unfading

(* How the eye looks: one camera of three is placed. *)
let view number random =
  let size () =
    if one_in random 3 then positive number random
    else choose random [| "1"; "2"; "5" |]
  in
  let placed () =
    let setting word =
      if one_in random 2 then "" else word ^ vector number random
    in
    "eye " ^ vector number random ^ setting " lookAt " ^ setting " up "
  and canvas () =
    Printf.sprintf "canvWidth %s canvHeight %s depth %s " (size ()) (size ())
      (size ())
  in
  match up_to random 5 with
  | 0 -> "fov " ^ choose random [| "1"; "60"; "179" |] ^ " " ^ placed ()
  | 1 -> canvas () ^ placed ()
  | _ -> canvas ()

let scene_of number random =
  let pixels () =
    if one_in random 100 then choose random strange
    else string_of_int (1 + up_to random 3)
  in
  Printf.sprintf
    "imWidth %s imHeight %s %s\n\
     bcolor %s raydepth %d%s\n\
     lights\n\
     %s\n\
     objects\n\
     %s\n"
    (pixels ()) (pixels ()) (view number random)
    (if one_in random 5 then "varying d [d * d + noise(3 * d) + 1]"
     else color number random)
    (up_to random 7)
    (if one_in random 4 then " ambient " ^ color number random else "")
    (some random 4 (light number))
    (some random 6 (object_ number))

let scene random =
  scene_of
    (choose random [| everyday; few; any_size; largest; mixture |])
    random

(* {1 Damage} *)

let damage random text =
  let length = String.length text in
  let at = up_to random length in
  let stop = Int.min length (at + up_to random 40) in
  let before = String.sub text 0 at
  and piece = String.sub text at (stop - at)
  and after = String.sub text stop (length - stop) in
  match up_to random 10 with
  | 0 -> before ^ after
  | 1 -> before ^ piece ^ piece ^ after
  | 2 -> before
  | 3 -> before ^ String.make 1 (any_byte random) ^ piece ^ after
  | 4 -> before ^ String.uppercase_ascii piece ^ after
  | 5 -> "\xef\xbb\xbf" ^ text
  | 6 -> String.concat "\r\n" (String.split_on_char '\n' text)
  | 7 -> after ^ before
  | 9 -> String.concat "\r" (String.split_on_char '\n' text)
  | 8 -> before ^ " " ^ mixture random ^ " " ^ after
  | _ -> before ^ choose random strange ^ piece ^ after

let rec damage_often random n text =
  if n = 0 then text else damage_often random (n - 1) (damage random text)

let damaged source random =
  damage_often random (1 + up_to random 3) (source random)

let kinds ~gallery =
  let gallery = Array.of_list gallery in
  [
    ("bytes", bytes);
    ("words", words);
    ("scene", scene);
    ("damaged scene", damaged scene);
    ("program", Random_program.scene);
    ("damaged program", damaged Random_program.scene);
  ]
  @
  if gallery = [||] then []
  else [ ("damaged gallery", damaged (fun random -> choose random gallery)) ]

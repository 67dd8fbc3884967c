open Raylab_geometry
open Raylab_source
open Raylab_scene
open Raylab_language
open Test_support

exception Wrong of string

let wrong what = raise (Wrong what)

(* {1 Plain values} *)

let float : Yojson.Safe.t -> float = function
  | `Float x -> x
  | `Int n -> float_of_int n
  | `Null -> nan
  | _ -> wrong "not a number"

let int : Yojson.Safe.t -> int = function
  | `Int n -> n
  | _ -> wrong "not an integer"

let bool : Yojson.Safe.t -> bool = function
  | `Bool b -> b
  | _ -> wrong "not a truth value"

let text : Yojson.Safe.t -> string = function
  | `String s -> s
  | _ -> wrong "not a string"

let list item : Yojson.Safe.t -> _ = function
  | `List items -> List.map item items
  | _ -> wrong "not a list"

let optional value : Yojson.Safe.t -> _ = function
  | `Null -> None
  | json -> Some (value json)

let three make json =
  match list float json with
  | [ a; b; c ] -> make a b c
  | _ -> wrong "not three numbers"

let vector = three Vec3.make
let color = three Color.make
let direction json = Direction.of_vec3_exn (vector json)

(* [members names json] looks up members, which are exactly [names]. *)
let members names : Yojson.Safe.t -> string -> Yojson.Safe.t = function
  | `Assoc found ->
      if List.map fst found <> names then
        wrong ("members " ^ String.concat ", " (List.map fst found));
      fun name -> List.assoc name found
  | _ -> wrong "not an object"

let member name : Yojson.Safe.t -> Yojson.Safe.t = function
  | `Assoc found when List.mem_assoc name found -> List.assoc name found
  | _ -> wrong ("no " ^ name)

let kind json = text (member "kind" json)

(* {1 Scenes} *)

let read_words words =
  let header = "imWidth 1 imHeight 1 canvWidth 1 canvHeight 1 depth 1" in
  let source =
    Sources.make ~name:"JSON" (String.concat "\n" (header :: words))
  in
  match Scene_file.parse ~access:Test_support.Meshes.access source with
  | Ok { objects = [ o ]; _ } -> o
  | _ -> wrong (String.concat " " words)

(* [written json] is the words of the scene language for a shape or surface: its
   kind, and its parts in their order. The name of a file is in quotes. *)
let rec written : Yojson.Safe.t -> string list = function
  | `Assoc members -> List.concat_map written_member members
  | `List items -> List.concat_map written items
  | `String word -> [ word ]
  | number -> [ Number.to_exact_string (float number) ]

and written_member = function
  | "file", name -> [ Printf.sprintf "%S" (text name) ]
  | "weight", (`List _ as color) ->
      [ Printf.sprintf "[%s]" (String.concat ", " (written color)) ]
  | _, part -> written part

let rec surface json : Surface.t =
  let weight : Yojson.Safe.t -> Color.t = function
    | `List _ as json -> color json
    | json ->
        let x = float json in
        Color.make x x x
  in
  let part json =
    (weight (member "weight" json), surface (member "surface" json))
  and number name = float (member name json)
  and tint () = color (member "color" json) in
  match kind json with
  | "diffusive" -> Surface.diffusive (color (member "color" json))
  | "reflective" -> Surface.reflective
  | "luminous" -> Surface.luminous (color (member "color" json))
  | "glossy" -> Surface.glossy ~sharpness:(number "sharpness") (tint ())
  | "refractive" -> Surface.refractive ~index:(number "index") (tint ())
  | "glass" -> Surface.glass ~index:(number "index") (tint ())
  | "mixed" -> Surface.tinted (list part (member "parts" json))
  | "checker" ->
      Surface.checker
        (float (member "size" json))
        (surface (member "even" json))
        (surface (member "odd" json))
  | "varying" -> varying json
  | other -> wrong other

(* What its names are, as the language defines them. *)
and varying json =
  let definition json =
    let name = text (member "name" json) in
    match json with
    | `Assoc members when List.mem_assoc "function" members ->
        "let " ^ text (member "function" json)
    | _ -> Printf.sprintf "let %s = %s" name (value (member "value" json))
  in
  let definitions = list definition (member "where" json) in
  let o =
    read_words (definitions @ [ "sphere 0 0 0 1"; text (member "text" json) ])
  in
  o.surface

and value : Yojson.Safe.t -> string = function
  | `List items -> "[" ^ String.concat ", " (List.map value items) ^ "]"
  | number -> Number.to_exact_string (float number)

let exact ppf x = Format.pp_print_string ppf (Number.to_exact_string x)

(* [written_surface definitions json] is the words for a surface, after what is
   added to [definitions]. *)
let written_surface definitions json =
  let surface = surface json in
  let name part =
    let name = Printf.sprintf "part_%d" (List.length !definitions) in
    definitions := (part, name) :: !definitions
  and name_of part = List.assq_opt part !definitions in
  List.iter name (Surface.parts_to_name surface);
  Format.asprintf "%a" (Surface.pp_with ~name_of exact) surface

(* Each pattern in a block of its own, for the names in it. *)
let read definitions words =
  let name_of part = List.assq_opt part definitions in
  let pp_names ppf : Surface.t -> unit = function
    | Varying { pattern; _ } -> Pattern_text.definitions ~name_of ppf pattern
    | _ -> ()
  in
  let definition (part, name) =
    Format.asprintf "if (true) %alet %s = %a" pp_names part name
      (Surface.pp_form_with ~name_of exact)
      part
  in
  let ends = List.map (fun _ -> "end") definitions in
  read_words (List.rev_map definition definitions @ words @ ends)

(* The same without the places of expressions. *)
let rec bare : Surface.t -> Surface.t = function
  | Mixed { parts; _ } ->
      Surface.tinted (List.map (fun (weight, s) -> (weight, bare s)) parts)
  | Checker { size; even; odd; _ } ->
      Surface.checker size (bare even) (bare odd)
  | Varying { pattern; _ } ->
      let expression = Raylab_expression.Names.without_places in
      let parameter (p : Raylab_expression.Expression.parameter) =
        { p with span = { start = 0; stop = 0 } }
      in
      let definition : _ Raylab_expression.Closed.definition -> _ = function
        | Defined { parameters; body } ->
            Raylab_expression.Closed.Defined
              {
                parameters = List.map parameter parameters;
                body = expression body;
              }
        | Value _ as value -> value
      in
      Surface.varying
        {
          pattern with
          body = expression pattern.body;
          definitions =
            List.map
              (fun (name, d) -> (name, definition d))
              pattern.definitions;
        }
  | simple -> simple

let place_members : Yojson.Safe.t -> string list = function
  | `Assoc found when List.mem_assoc "file" found -> [ "line"; "file" ]
  | _ -> [ "line" ]

let origin json =
  let line = optional int (member "line" json) in
  match (line, place_members json) with
  | None, _ -> Origin.Unknown
  | Some line, [ _ ] -> Build.at_line line
  | Some line, _ ->
      if text (member "file" json) <> "wood.scene" then wrong "file";
      Build.at_line_of_wood line

let changes : Yojson.Safe.t -> string list = function
  | `Assoc found when List.mem_assoc "modifiers" found -> [ "modifiers" ]
  | _ -> []

let has name : Yojson.Safe.t -> bool = function
  | `Assoc found -> List.mem_assoc name found
  | _ -> false

let plain_parts json = [ "shape"; "surface" ] @ changes json

let of_part definitions part json =
  if part = "surface" then [ written_surface definitions json ]
  else written json

(* [solid definitions json] is the words for what is put together, or for a
   primitive. *)
let rec solid definitions json =
  if has "primitive" json then
    let parts = plain_parts json in
    let get = members ("primitive" :: parts) json in
    List.concat_map (fun part -> of_part definitions part (get part)) parts
  else
    let get = members [ "kind"; "parts" ] json in
    (text (get "kind") :: List.concat (list (solid definitions) (get "parts")))
    @ [ "end" ]

(* Primitives are told without their places. *)
let unplaced (o : Object.t) =
  match o.shape with
  | Solid { tree; _ } ->
      let primitive m = Object.with_origin Origin.Unknown o.primitives.(m) in
      let solid = Object.solid (Solid.map_tree primitive tree) in
      if o.is_shadowless then Object.shadowless solid else solid
  | _ -> o

let object_ json =
  let parts = if has "solid" json then [ "solid" ] else plain_parts json in
  let shadowless = if has "shadowless" json then [ "shadowless" ] else [] in
  let get =
    members (("number" :: place_members json) @ parts @ shadowless) json
  in
  let definitions = ref [] in
  let words part =
    if part = "solid" then solid definitions (get part)
    else of_part definitions part (get part)
  in
  let words = List.concat_map words parts in
  let o = read !definitions (words @ shadowless) in
  let o = Object.map_surfaces bare o in
  let origin = origin json in
  ( int (get "number"),
    Object.with_origin origin (unplaced o),
    Build.place origin )

let primitive json (o : Object.t) =
  if not (has "primitive" json) then ([], None)
  else
    let json = member "primitive" json in
    let names = ("number" :: place_members json) @ [ "taken_away" ] in
    let get = members names json in
    let index = int (get "number") in
    let origin = origin json in
    let is_taken_away = bool (get "taken_away") in
    let place = Build.place origin in
    let object_ =
      Object.with_origin origin (Object.primitive o (Some index))
    in
    ( [ "primitive" ],
      Some { Raylab_tracer.Explain.index; object_; place; is_taken_away } )

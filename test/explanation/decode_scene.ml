open Raylab_geometry
open Raylab_scene

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

let shape json =
  match kind json with
  | "sphere" ->
      let get = members [ "kind"; "centre"; "radius" ] json in
      Shape.sphere
        ~centre:(vector (get "centre"))
        ~radius:(float (get "radius"))
  | "plane" ->
      let get = members [ "kind"; "point"; "normal" ] json in
      Shape.plane ~point:(vector (get "point")) ~normal:(vector (get "normal"))
  | other -> wrong other

let rec surface json =
  match kind json with
  | "diffusive" ->
      Surface.diffusive (color (members [ "kind"; "color" ] json "color"))
  | "luminous" ->
      Surface.luminous (color (members [ "kind"; "color" ] json "color"))
  | "reflective" ->
      ignore (members [ "kind" ] json : string -> _);
      Surface.reflective
  | "mixed" ->
      Surface.mixed (list part (members [ "kind"; "parts" ] json "parts"))
  | other -> wrong other

and part json =
  let get = members [ "weight"; "surface" ] json in
  (float (get "weight"), surface (get "surface"))

let object_ json =
  let get = members [ "number"; "line"; "shape"; "surface" ] json in
  ( int (get "number"),
    Object.make
      ?line:(optional int (get "line"))
      (shape (get "shape"))
      (surface (get "surface")) )

open Printf

let choose random items = items.(Random.State.int random (Array.length items))
let up_to random n = Random.State.int random (n + 1)

(* {1 Names} *)

(* What a name stands for. A scope is a list of names with their kinds. *)
type kind =
  | Number
  | Vector
  | List
  | Surface
  | Object
  | Solid  (** an object with an inside *)
  | Number_of of int  (** a function of so many numbers *)
  | Object_of of int
  | Solid_of of int

let words = [| "a"; "B"; "count_"; "x2"; "size"; "sphere1"; "Pi2"; "time3" |]

(* A name of its own, so that it is no word and defined only once. *)
let fresh random scope =
  sprintf "%s_%d" (choose random words) (Stdlib.List.length scope)

let of_kind kind scope =
  Stdlib.List.filter_map
    (fun (name, k) -> if k = kind then Some name else None)
    scope

let some_name random kind scope =
  match of_kind kind scope with
  | [] -> None
  | names -> Some (choose random (Array.of_list names))

let commas make n = String.concat ", " (Stdlib.List.init n (fun _ -> make ()))

(* {1 Expressions} *)

let literal random =
  choose random
    [| "0"; "1"; "2"; "0.5"; "3"; "7.25"; "1e-3"; "90"; "1e9"; "0.1" |]

let function_of scope =
  Stdlib.List.find_map
    (fun (name, k) -> match k with Number_of n -> Some (name, n) | _ -> None)
    scope

let rec number_in scope depth random =
  if depth = 0 then simple scope random
  else
    let n () = number_in scope (depth - 1) random
    and v () = vector_in scope (depth - 1) random in
    match up_to random 15 with
    | 0 | 1 -> simple scope random
    | 2 | 3 | 4 ->
        sprintf "(%s) %s (%s)" (n ())
          (choose random [| "+"; "-"; "*"; "/" |])
          (n ())
    | 5 ->
        sprintf "%s %s %s" (simple scope random)
          (choose random [| "+"; "-"; "*"; "^" |])
          (simple scope random)
    | 6 -> sprintf "-(%s)" (n ())
    | 7 ->
        sprintf "if %s then %s else %s"
          (truth_in scope (depth - 1) random)
          (n ()) (n ())
    | 8 ->
        let name = fresh random scope in
        sprintf "let %s = %s in %s" name (n ())
          (number_in ((name, Number) :: scope) (depth - 1) random)
    | 9 ->
        sprintf "%s(%s)"
          (choose random [| "sin"; "COS"; "abs"; "floor"; "random"; "round" |])
          (n ())
    | 10 ->
        sprintf "%s(%s, %s)"
          (choose random [| "min"; "max"; "mod"; "atan2" |])
          (n ()) (n ())
    | 11 -> sprintf "clamp(x: %s, low: 0, high: 1)" (n ())
    | 12 -> sprintf "(%s).%s" (v ()) (choose random [| "x"; "Y"; "z"; "g" |])
    | 13 -> sprintf "%s(%s)" (choose random [| "length"; "noise" |]) (v ())
    | 14 -> sprintf "count(%s)" (list_in scope (depth - 1) random)
    | _ -> (
        match function_of scope with
        | Some (name, arity) -> sprintf "%s(%s)" name (commas n arity)
        | None -> n ())

and simple scope random =
  match some_name random Number scope with
  | Some name when Random.State.bool random -> name
  | _ -> literal random

and truth_in scope depth random =
  let n () = number_in scope depth random in
  match up_to random (if depth = 0 then 1 else 4) with
  | 0 -> choose random [| "true"; "false" |]
  | 1 ->
      sprintf "(%s) %s (%s)" (n ())
        (choose random [| "="; "<>"; "<"; "<="; ">"; ">=" |])
        (n ())
  | 2 -> sprintf "not %s" (truth_in scope (depth - 1) random)
  | _ ->
      sprintf "(%s) %s (%s)"
        (truth_in scope (depth - 1) random)
        (choose random [| "and"; "or" |])
        (truth_in scope (depth - 1) random)

and vector_in scope depth random =
  let n () = number_in scope (Int.max 0 (depth - 1)) random in
  let triple () = sprintf "[%s, %s, %s]" (n ()) (n ()) (n ()) in
  match up_to random (if depth = 0 then 1 else 5) with
  | 0 -> triple ()
  | 1 -> Option.value (some_name random Vector scope) ~default:(triple ())
  | 2 -> sprintf "%s + %s" (triple ()) (vector_in scope (depth - 1) random)
  | 3 -> sprintf "(%s) * %s" (n ()) (triple ())
  | 4 -> sprintf "hsv(%s, 0.5, 1)" (n ())
  | _ -> sprintf "mix(%s, %s, 0.5)" (triple ()) (triple ())

and list_in scope depth random =
  let n scope = number_in scope (Int.max 0 (depth - 1)) random in
  let name = fresh random scope in
  let inner = (name, Number) :: scope in
  match up_to random 3 with
  | 0 -> sprintf "[%s]" (commas (fun () -> n scope) (up_to random 4))
  | 1 -> sprintf "[for %s = 0 to %d: %s]" name (up_to random 5) (n inner)
  | 2 -> sprintf "[for %s in [1, 2, 3, 4]: %s]" name (n inner)
  | _ -> Option.value (some_name random List scope) ~default:"[1, 2]"

let number random = number_in [] 4 random

(* {1 Items} *)

let atom scope random =
  match up_to random 2 with
  | 0 -> choose random [| "1"; "-2"; "0.5"; "6"; "+3" |]
  | 1 -> (
      match some_name random Number scope with
      | Some name -> name
      | None -> "1.5")
  | _ -> sprintf "(%s)" (number_in scope 2 random)

let triple scope random =
  let a () = atom scope random in
  if up_to random 3 = 0 then
    match some_name random Vector scope with
    | Some name -> sprintf "[%s]" name
    | None -> sprintf "[%s]" (vector_in scope 2 random)
  else sprintf "%s %s %s" (a ()) (a ()) (a ())

(* Mostly in range, so that the rest of the scene is reached. *)
let positive scope random =
  if up_to random 30 = 0 then sprintf "(%s)" (number_in scope 2 random)
  else sprintf "(0.1 + abs(clamp(%s, -9, 9)))" (number_in scope 2 random)

let color scope random =
  match up_to random 3 with
  | 0 -> choose random [| "red"; "White"; "gold"; "0.2 .5 1" |]
  | 1 -> sprintf "[hsv(%s, 0.7, 1)]" (number_in scope 2 random)
  | _ ->
      let p () = positive scope random in
      sprintf "%s %s %s" (p ()) (p ()) (p ())

let rec own_surface scope depth random =
  match up_to random (if depth = 0 then 4 else 8) with
  | 0 -> "diffusive " ^ color scope random
  | 1 -> "reflective"
  | 2 -> "luminous " ^ color scope random
  | 3 -> sprintf "glass %s %s" (positive scope random) (color scope random)
  | 4 ->
      sprintf "%s %s %s"
        (choose random [| "refractive"; "glossy" |])
        (positive scope random) (color scope random)
  | 5 ->
      sprintf "mixed [gold] %s [hsv(%s, 0.5, 1)] %s"
        (own_surface scope (depth - 1) random)
        (number_in scope 1 random)
        (surface scope (depth - 1) random)
  | 6 ->
      sprintf "checker %s %s %s" (positive scope random)
        (surface scope (depth - 1) random)
        (surface scope (depth - 1) random)
  | 7 ->
      sprintf
        "varying p mixed (abs(mod(p.x, 2))) %s 0.5 diffusive [abs(%s), \
         noise(p) + 1, 1]"
        (own_surface scope 0 random)
        (number_in scope 2 random)
  | _ ->
      sprintf "mixed 0.5 %s (%s) %s"
        (own_surface scope (depth - 1) random)
        (positive scope random)
        (surface scope (depth - 1) random)

and surface scope depth random =
  match some_name random Surface scope with
  | Some name when Random.State.bool random -> name
  | _ -> own_surface scope depth random

let modifier scope random =
  match up_to random 3 with
  | 0 -> "scaled " ^ positive scope random
  | 1 -> "translated " ^ triple scope random
  | 2 ->
      sprintf "stretched %s -2 %s" (positive scope random)
        (positive scope random)
  | _ -> sprintf "rotated 0 1 0.5 %s" (atom scope random)

let modified scope random thing =
  String.concat "  "
    (thing
    :: Stdlib.List.init (up_to random 2) (fun _ -> modifier scope random))

let shape scope random =
  let p () = triple scope random and r () = positive scope random in
  match up_to random 8 with
  | 0 -> sprintf "box %s %s" (p ()) (p ())
  | 1 -> sprintf "cylinder %s %s %s" (p ()) (p ()) (r ())
  | 2 -> sprintf "cone %s 0 %s %s" (p ()) (p ()) (r ())
  | 3 -> sprintf "torus %s 0 1 %s 2 0.5" (p ()) (r ())
  | 4 -> sprintf "plane %s 0 1 %s" (p ()) (r ())
  | _ -> sprintf "sphere %s %s" (p ()) (r ())

let flat scope random =
  let p () = triple scope random in
  match up_to random 2 with
  | 0 -> sprintf "disc %s 0 1 0 %s" (p ()) (positive scope random)
  | 1 -> sprintf "triangle %s %s %s" (p ()) (p ()) (p ())
  | _ -> sprintf "quad %s 1 0 %s 0 1 1" (p ()) (positive scope random)

let solid_leaf scope random = shape scope random ^ " " ^ surface scope 1 random

let leaf scope random =
  modified scope random
    (match up_to random 9 with
    | 0 -> flat scope random ^ " " ^ surface scope 1 random
    | 1 ->
        sprintf "spherical %s %s %s" (positive scope random)
          (color scope random) (triple scope random)
    | 2 ->
        sprintf "directional 0.8 %s 1 %s -1" (color scope random)
          (positive scope random)
    | 3 | 4 -> solid_leaf scope random
    | 5 ->
        sprintf "spot %s %s 0 3 0 %s 10 (10 * 2) unfading"
          (positive scope random) (color scope random) (triple scope random)
    | 6 ->
        sprintf "area %s %s %s 1 0 0 0 %s 1 2" (positive scope random)
          (color scope random) (triple scope random) (positive scope random)
    | _ ->
        sprintf "sphere %s %s %s" (triple scope random) (positive scope random)
          (surface scope 2 random))

(* One of the names that [is_it], or else what [other] makes. *)
let reference_to is_it other scope random =
  match Stdlib.List.filter (fun (_, kind) -> is_it kind) scope with
  | [] -> other scope random
  | named -> (
      match choose random (Array.of_list named) with
      | name, (Object_of n | Solid_of n) ->
          let argument () = sprintf "%d" (up_to random 2) in
          modified scope random (sprintf "%s(%s)" name (commas argument n))
      | name, _ -> modified scope random name)

let is_solid = function Solid | Solid_of _ -> true | _ -> false
let is_object = function Object | Object_of _ -> true | kind -> is_solid kind
let reference scope random = reference_to is_object leaf scope random

(* {1 Solids} *)

let rec solid scope depth random =
  match up_to random (if depth = 0 then 2 else 6) with
  | 0 | 1 -> modified scope random (solid_leaf scope random)
  | 2 -> reference_to is_solid solid_leaf scope random
  | _ -> modified scope random (grouping scope depth random)

and grouping scope depth random =
  let word =
    choose random [| "union"; "intersection"; "difference"; "difference" |]
  in
  sprintf "%s\n%s%send" word
    (solid scope (depth - 1) random ^ "\n")
    (solids scope (depth - 1) random)

(* Those after the first one. *)
and solids scope depth random =
  let one _ =
    let several scope = solids scope (Int.max 0 (depth - 1)) random in
    String.cat
      (match up_to random (if depth = 0 then 1 else 5) with
      | 0 | 1 -> solid scope depth random
      | 2 -> sprintf "group\n%send" (several scope)
      | 3 ->
          let name = fresh random scope in
          sprintf "for %s = 0 to %d\n%send" name (up_to random 2)
            (several ((name, Number) :: scope))
      | 4 -> sprintf "if (%s)\n%send" (truth_in scope 1 random) (several scope)
      | _ ->
          let name = fresh random scope in
          sprintf "let %s = (%s)\n%s" name (number_in scope 2 random)
            (solid ((name, Number) :: scope) depth random))
      "\n"
  in
  String.concat "" (Stdlib.List.init (up_to random 2) one)

let shadowless random text =
  if up_to random 3 = 0 then text ^ " shadowless" else text

let rec item scope depth random =
  let block scope = block scope (depth - 1) random in
  match up_to random (if depth = 0 then 2 else 9) with
  | 0 | 1 -> leaf scope random
  | 8 | 9 ->
      shadowless random (modified scope random (grouping scope depth random))
  | 2 -> reference scope random
  | 3 -> modified scope random (sprintf "group\n%send" (block scope))
  | 4 ->
      let name = fresh random scope in
      sprintf "for %s = 0 to %d\n%send" name (up_to random 3)
        (block ((name, Number) :: scope))
  | 5 ->
      let name = fresh random scope in
      sprintf "for %s in %s\n%send" name "[1, 2.5]"
        (block ((name, Number) :: scope))
  | 6 -> sprintf "if (%s)\n%send" (truth_in scope 2 random) (block scope)
  | _ ->
      (* after else an if would go on with this one *)
      sprintf "if (%s)\n%selse if (%s)\n%selse\n%s\n%send"
        (truth_in scope 2 random) (block scope) (truth_in scope 1 random)
        (block scope) (leaf scope random) (block scope)

and block scope depth random =
  let rec items scope n =
    if n = 0 then []
    else if up_to random 2 = 0 then
      let text, scope = definition scope (Int.max 0 (depth - 1)) random in
      text :: items scope (n - 1)
    else item scope depth random :: items scope (n - 1)
  in
  String.concat "\n" (items scope (1 + up_to random 2)) ^ "\n"

and definition scope depth random =
  let name = fresh random scope in
  let plain kind text =
    (sprintf "let %s = %s" name text, (name, kind) :: scope)
  in
  match up_to random 9 with
  | 8 -> plain Solid (grouping scope 2 random)
  | 9 ->
      let inner = ("u", Number) :: scope in
      ( sprintf
          "let %s(u) = difference\n%s\nif (u > 0)\n%s(u - 1) %s\nend\nend" name
          (solid inner 1 random) name (modifier inner random),
        (name, Solid_of 1) :: scope )
  | 0 | 1 -> plain Number (sprintf "(%s)" (number_in scope 3 random))
  | 2 ->
      plain Vector
        (sprintf "[%s, %s, 1]" (number_in scope 2 random)
           (number_in scope 2 random))
  | 3 -> plain List (sprintf "[for i = 1 to 4: %s]" (number_in scope 2 random))
  | 4 -> plain Surface (own_surface scope 2 random)
  | 5 -> plain Object (sprintf "group\n%send" (block scope depth random))
  | 6 ->
      let inner = ("u", Number) :: ("v", Number) :: scope in
      ( sprintf "let %s(u, v) = (%s)" name (number_in inner 3 random),
        (name, Number_of 2) :: scope )
  | _ ->
      (* calls itself, at most twice for each of few levels *)
      let inner = ("u", Number) :: scope in
      ( sprintf "let %s(u) = group\n%sif (u > 0)\n%s(u - 1) %s\nend\nend" name
          (block inner depth random) name (modifier inner random),
        (name, Object_of 1) :: scope )

let scene random =
  let rec definitions scope n =
    if n = 0 then ([], scope)
    else
      let text, scope = definition scope 1 random in
      let texts, scope = definitions scope (n - 1) in
      (text :: texts, scope)
  in
  let texts, scope = definitions [] (up_to random 5) in
  sprintf
    "imWidth 2 imHeight 2 canvWidth 4 canvHeight 3 depth 4\n%s\nobjects\n%s"
    (String.concat "\n" texts)
    (block scope 2 random ^ block scope 2 random)

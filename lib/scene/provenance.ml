open Raylab_source
open Raylab_expression

type what =
  | Call of { name : string; arguments : (string * Datum.t) list }
  | Round of { name : string; value : Datum.t }
  | By_name of string

type step = { what : what; place : Place.t option }
type t = { place : Place.t; steps : step list }

(* {1 What an origin says} *)

let step files (trail : Trail.t) =
  match trail with
  | Start -> None
  | Call { name; arguments; at; _ } ->
      Some { what = Call { name; arguments }; place = Files.place files at }
  | Round { loop = { name; at }; value; _ } ->
      Some { what = Round { name; value }; place = Files.place files at }

(* What is around a thing where it is placed is told once, there. *)
let rec steps files within (placed : Origin.placed) =
  match placed with
  | At_once -> List.filter_map (step files) (Trail.apart within ~from:Start)
  | By_name { name; at; within = here; around } ->
      List.filter_map (step files) (Trail.apart within ~from:here)
      @ { what = By_name name; place = Files.place files at }
        :: steps files here around

let make files (origin : Origin.t) =
  let found at steps =
    Option.map (fun place -> { place; steps }) (Files.place files at)
  in
  match origin with
  | Unknown -> None
  | Literal at -> found at []
  | Made { at; within } -> found at (steps files within At_once)
  | Placed { at; within; placed } -> found at (steps files within placed)

(* {1 Telling} *)

let longest = 60

(* Texts may be long. *)
let cut text =
  if String.length text <= longest then text
  else String.sub text 0 longest ^ "..."

let value datum = Printable.text (cut (Datum.to_string datum))

let told { what; place } =
  match (what, place) with
  | Call { name; arguments }, _ ->
      let argument (label, datum) = label ^ ": " ^ value datum in
      Printf.sprintf "in %s(%s)" name
        (String.concat ", " (List.map argument arguments))
  | Round { name; value = datum }, _ -> name ^ " = " ^ value datum
  | By_name name, None -> "placed as " ^ name
  | By_name name, Some place ->
      Printf.sprintf "placed as %s in %s" name (Place.to_string place)

let most_inner = 2
let most_outer = 2

let told_steps steps =
  let count = List.length steps in
  let tell keep = List.map told (List.filteri keep steps) in
  if count <= most_inner + most_outer then tell (fun _ _ -> true)
  else
    tell (fun k _ -> k < most_inner)
    @ [ Printf.sprintf "... %d more ..." (count - most_inner - most_outer) ]
    @ tell (fun k _ -> k >= count - most_outer)

(* Where the outermost step is written, if that says something new. *)
let outermost { place; steps } =
  match List.rev steps with
  | { what = Call _ | Round _; place = Some last } :: _ when last <> place ->
      [ Place.to_string last ]
  | _ -> []

let to_string provenance =
  String.concat ", "
    ((Place.to_string provenance.place :: told_steps provenance.steps)
    @ outermost provenance)

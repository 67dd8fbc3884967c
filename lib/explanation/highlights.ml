open Raylab_scene
open Raylab_tracer

let pf = Printf.sprintf
let is_black c = Color.equal c Color.black

let shines : Explain.verdict -> Color.t list = function
  | Lit { shines; _ } | Mean { shines; _ } -> shines
  | Faces_away _ | Outside _ | Blocked _ -> []

(* Whether a picture would show that it is there, as samples differ. *)
let is_seen film (h : Explain.surface_hit) shines =
  let term sum { Lobes.shine; _ } gets =
    Color.add sum (Color.multiply shine gets)
  in
  let color = List.fold_left2 term Color.black h.lobes.highlights shines in
  Color.largest (Film.encode film (Film.expose film color)) > 1. /. 32.

let is_all { Lobes.emission; albedo; mirror; refractions; _ } =
  refractions = [] && List.for_all is_black [ emission; albedo; mirror ]

let told say = function
  | [] -> []
  | [ number ] -> [ pf "%s the highlight of light %d" say number ]
  | numbers -> [ pf "%s the highlights of %s" say (Words.lights numbers) ]

let clauses film (h : Explain.surface_hit) =
  let lit { Explain.number; verdict; _ } =
    match shines verdict with
    | [] -> None
    | s -> Some (number, is_seen film h s)
  in
  let seen, unseen = List.partition snd (List.filter_map lit h.lights) in
  let numbers = List.map fst in
  told "in" (numbers seen)
  @
  if seen = [] && is_all h.lobes then told "outside of" (numbers unseen)
  else []

open Raylab_scene
open Raylab_tracer

let pf = Printf.sprintf

let rec through : Explain.verdict -> Explain.crossed list = function
  | Lit { through; _ } -> through
  | Mean { points; _ } -> List.concat_map through points
  | Faces_away _ | Outside _ | Blocked _ -> []

(* The part that came out: of an area light that of all its points that are
   seen, in the mean. *)
let rec tint : Explain.verdict -> Color.t option = function
  | Lit { through; _ } -> Some (Explain.tint through)
  | Faces_away _ | Outside _ | Blocked _ -> None
  | Mean { points; _ } -> (
      match List.filter_map tint points with
      | [] -> None
      | tints ->
          let sum = List.fold_left Color.add Color.black tints in
          Some (Color.scale (1. /. float_of_int (List.length tints)) sum))

let told ~exact went tint =
  match Color_word.hue tint with
  | Some _ ->
      let whole = Saturate.limit (1. /. Color.largest tint) in
      let bright = Saturate.color (Color.scale whole tint) in
      pf "in %s: %s" (Words.a (Color_word.of_color bright ^ " shadow")) went
  | None when exact ->
      pf "in a weak shadow: %s, and %s of it came out" went
        (Words.rough_percent (Color.largest tint))
  | None -> "in a weak shadow: " ^ went

let clause ~exact { Explain.number; verdict; _ } =
  let name { Explain.by; object_; place; _ } =
    (by, Naming.by_number by object_ place)
  in
  match (through verdict, tint verdict) with
  | [], _ | _, None -> None
  | through, Some tint ->
      let names = List.sort_uniq compare (List.map name through) in
      let names = Words.list (List.map snd names) in
      let went = pf "light %d went through %s" number names in
      Some (told ~exact went tint)

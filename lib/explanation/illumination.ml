open Raylab_geometry
open Raylab_scene
open Raylab_tracer

let pf = Printf.sprintf
let is_black c = Color.equal c Color.black
let shows_black film c = Film.to_bytes film (Film.expose film c) = (0, 0, 0)

(* {1 What each light does} *)

type t =
  | Full
  | Edge of float  (** of the cone of a spot, at this angle *)
  | Beyond of float
  | Hidden of Points_seen.blocker list
  | Behind of float
  | Partly of Points_seen.t

module Numbers = Map.Make (Int)

let of_points points =
  let ({ Points_seen.seen; points = count; hidden; _ } as part) =
    Points_seen.make points
  in
  if seen = count then Full
  else if seen > 0 then Partly part
  else if hidden <> [] then Hidden (List.map fst hidden)
  else
    let cosine : Explain.verdict -> float = function
      | Faces_away { cosine } -> cosine
      | _ -> 0.
    in
    Behind (List.fold_left Float.min 0. (List.map cosine points))

let of_verdict : Explain.verdict -> t = function
  | Lit { cone = Some { angle; part }; _ } when part < 1. -> Edge angle
  | Lit _ -> Full
  | Outside { angle } -> Beyond angle
  | Blocked { by; blocker; place; _ } ->
      Hidden [ Points_seen.blocker by blocker place ]
  | Faces_away { cosine } -> Behind cosine
  | Mean { points; _ } -> of_points points

(* Of each light that [choose] takes: its number, and what of it. *)
let pick choose lights =
  let chosen (number, does) =
    Option.map (fun x -> (number, x)) (choose does)
  in
  List.filter_map chosen lights

(* {1 In words} *)

let partly ~exact (number, ({ Points_seen.seen; points; _ } as part)) =
  let others = Points_seen.others ~exact part in
  if exact then
    pf "lit by %d of %d points of light %d, while %s" seen points number others
  else pf "lit by a part of light %d, while %s" number others

(* The blocked lights by what blocks them: its name and the lights. *)
let shadows (h : Explain.surface_hit) blocked =
  let add groups (light, { Points_seen.by; name }) =
    let join = function
      | None -> Some (name, [ light ])
      | Some (name, lights) -> Some (name, light :: lights)
    in
    Numbers.update by join groups
  in
  let shadow (by, (name, lights)) =
    let lights = Words.lights (List.rev lights) in
    if by = h.hit.number then "its own shadow from " ^ lights
    else pf "the shadow of %s from %s" name lights
  in
  let groups = Numbers.bindings (List.fold_left add Numbers.empty blocked) in
  "in " ^ Words.list (List.map shadow groups)

let faces_away (h : Explain.surface_hit) lights =
  let clause say = function
    | [] -> []
    | lights -> [ say (Words.lights (List.map fst lights)) ]
  in
  let { Object.shape; _ } = Object.primitive h.object_ h.hit.primitive in
  match Shape.outline shape with
  | Ball _ | Body _ | Several _ ->
      clause (fun lights -> "facing away from " ^ lights) lights
  | Endless _ | Patch _ ->
      let behind, beside =
        List.partition (fun (_, cosine) -> cosine < 0.) lights
      in
      clause (pf "with %s behind it") behind
      @ clause (fun lights -> "edge-on to " ^ lights) beside

let cones ~exact say = function
  | [] -> []
  | [ (number, angle) ] when exact ->
      [
        pf "%s the cone of light %d, %s degrees from its axis" say number
          (Words.number angle);
      ]
  | [ (number, _) ] -> [ pf "%s the cone of light %d" say number ]
  | several ->
      [ pf "%s the cones of %s" say (Words.lights (List.map fst several)) ]

let diffused =
  Explain.sum_of (function
    | Diffused _ -> true
    | Background | Emitted | Shine _ | Mirror _ | Refraction _ -> false)

let but film e =
  let diffused = diffused e in
  if not (shows_black film diffused) then ""
  else if is_black (Explain.light e) then ", which gives no light"
  else if is_black diffused then ", but returns nothing of its colour"
  else ", but too weakly to be seen"

let lit_clauses ~exact film e lights =
  let full = pick (function Full -> Some () | _ -> None) lights
  and edge = pick (function Edge angle -> Some angle | _ -> None) lights
  and parts = pick (function Partly part -> Some part | _ -> None) lights in
  let whole = List.map fst full @ List.map fst edge in
  let clauses =
    (if whole = [] then []
     else [ "lit by " ^ Words.lights (List.sort Int.compare whole) ])
    @ cones ~exact "at the edge of" edge
    @ List.map (partly ~exact) parts
  in
  let more =
    if is_black (Explain.ambient e) then but film e
    else
      let comma =
        match clauses with [ _ ] when parts = [] -> "" | _ -> ","
      in
      comma ^ " and by ambient light" ^ but film e
  in
  match List.rev clauses with
  | [] -> []
  | last :: before -> List.rev ((last ^ more) :: before)

(* {1 All together} *)

let clauses ~exact film (e : Explain.t) (h : Explain.surface_hit) =
  let lights =
    List.map
      (fun { Explain.number; verdict; _ } -> (number, of_verdict verdict))
      h.lights
  in
  let shine =
    if h.lobes.highlights = [] then [] else Highlights.clauses film h
  in
  let is_matt = not (is_black h.lobes.albedo) in
  let lit =
    (if is_matt then
       lit_clauses ~exact film e lights
       @ List.filter_map (Filtered.clause ~exact) h.lights
     else [])
    @ shine
  and hidden =
    pick (function Hidden blockers -> Some blockers | _ -> None) lights
    |> List.concat_map (fun (n, all) -> List.map (fun b -> (n, b)) all)
  and beyond = pick (function Beyond angle -> Some angle | _ -> None) lights
  and behind =
    pick (function Behind cosine -> Some cosine | _ -> None) lights
  in
  let unlit =
    (if hidden = [] then [] else [ shadows h hidden ])
    @ cones ~exact "outside of" beyond
    @ faces_away h behind
  in
  let is_ambient = is_matt && not (is_black (Explain.ambient e)) in
  if not (is_matt || Highlights.is_all h.lobes) then shine
  else if lights = [] then
    [
      (if is_ambient then "lit by ambient light" ^ but film e
       else "with no light in the scene");
    ]
  else if lit <> [] then lit @ unlit
  else if is_ambient then
    unlit @ [ "so that only ambient light reaches it" ^ but film e ]
  else unlit @ [ "so that no light reaches it" ]

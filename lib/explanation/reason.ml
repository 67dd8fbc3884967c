open Raylab_geometry
open Raylab_scene
open Raylab_tracer

let is_black c = Color.equal c Color.black
let shows_black film c = Film.to_bytes film (Film.expose film c) = (0, 0, 0)

(* {1 Lights} *)

module Numbers = Map.Make (Int)

(* The blocked lights by what blocks them: its name and the lights. *)
let by_blocker blocked =
  let add groups (light, by, name) =
    let join = function
      | None -> Some (name, [ light ])
      | Some (name, lights) -> Some (name, light :: lights)
    in
    Numbers.update by join groups
  in
  Numbers.bindings (List.fold_left add Numbers.empty blocked)

let diffused =
  Explain.sum_of (function
    | Diffused _ -> true
    | Background | Emitted | Mirror -> false)

let lit film (e : Explain.t) numbers =
  let diffused = diffused e in
  let but =
    if not (shows_black film diffused) then ""
    else if is_black (Explain.light e) then ", which gives no light"
    else if is_black diffused then ", but returns nothing of its colour"
    else ", but too weakly to be seen"
  in
  "lit by " ^ Words.lights numbers ^ but

let shadows (h : Explain.surface_hit) blocked =
  let shadow (by, (name, lights)) =
    let lights = Words.lights (List.rev lights) in
    if by = h.hit.number then "its own shadow from " ^ lights
    else Printf.sprintf "the shadow of %s from %s" name lights
  in
  "in " ^ Words.list (List.map shadow (by_blocker blocked))

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
      clause (Printf.sprintf "with %s behind it") behind
      @ clause (fun lights -> "edge-on to " ^ lights) beside

let light_clauses film e (h : Explain.surface_hit) =
  let pick choose = List.filter_map choose h.lights in
  let are_lit =
    pick (fun { number; verdict; _ } ->
        match verdict with Lit _ -> Some number | _ -> None)
  and are_blocked =
    pick (fun { number; verdict; _ } ->
        match verdict with
        | Blocked { by; blocker; place; _ } ->
            Some (number, by, Naming.by_number by blocker place)
        | _ -> None)
  and are_behind =
    pick (fun { number; verdict; _ } ->
        match verdict with
        | Faces_away { cosine } -> Some (number, cosine)
        | _ -> None)
  in
  let clause say = function [] -> [] | some -> [ say some ] in
  let clauses =
    clause (lit film e) are_lit
    @ clause (shadows h) are_blocked
    @ faces_away h are_behind
  in
  if is_black h.lobes.albedo then []
  else if clauses = [] then [ "with no light in the scene" ]
  else if are_lit = [] then clauses @ [ "so that no light reaches it" ]
  else clauses

(* {1 What a ray meets} *)

let the phrase = "the " ^ phrase

let rec path e =
  match Explain.next e with [] -> [ e ] | next :: _ -> e :: path next

let clauses film e (h : Explain.surface_hit) =
  if Lobes.is_none h.lobes then [ "which returns no light" ]
  else light_clauses film e h

(* [describe film ~depth ~article path] is about the rays of [path], the last
   ones of a chain of at most [depth]. *)
let rec describe film ~depth ~article (path : Explain.t list) =
  match path with
  | ({ outcome = Hit h; _ } as e) :: rest ->
      let { Object.shape; _ } = Object.primitive h.object_ h.hit.primitive in
      let look =
        article
          (Naming.by_look ?primitive:h.primitive h.hit.number h.object_
             h.surface h.place)
        |> Naming.with_part shape h.hit.part
      in
      let clauses = clauses film e h in
      String.concat ", " (look :: clauses) ^ shows film ~depth h rest
  | { outcome = Missed; color; _ } :: _ -> article (Naming.background color)
  | { outcome = Chain_ended; color; _ } :: _ when depth = 0 ->
      article (Naming.background color)
      ^ ", because raydepth is 0 and no ray is followed"
  | { outcome = Chain_ended; color; _ } :: _ ->
      Printf.sprintf "%s, because the chain of %d %s has ended"
        (article (Naming.background color))
        depth
        (if depth = 1 then "ray" else "rays")
  | [] -> ""

and shows film ~depth h rest =
  let is_mirror = is_black h.lobes.albedo && is_black h.lobes.emission in
  let verb = if is_mirror then " that shows" else ", whose mirror shows" in
  match rest with
  | [] -> ""
  | [ _ ] | [ _; _ ] -> verb ^ " " ^ describe film ~depth ~article:the rest
  | _ ->
      let between = List.length rest - 1 in
      Printf.sprintf "%s, by way of %d more mirrors, %s" verb between
        (describe film ~depth ~article:the [ List.nth rest between ])

(* {1 Brightness} *)

let over_exposed { Film.exposure; _ } { Color.r; g; b } =
  let channel name x =
    let x = Saturate.limit (exposure *. x) in
    (* a level above 255, if there were one *)
    if x *. 255. > 255.5 then Some (name ^ " " ^ Words.number x) else None
  in
  match
    List.filter_map Fun.id
      [ channel "red" r; channel "green" g; channel "blue" b ]
  with
  | [] -> ""
  | channels -> "; over-exposed: " ^ Words.list channels ^ ", shown as 255"

let of_ray film (e : Explain.t) =
  let article, what =
    match e.outcome with
    | Hit _ -> (Words.a, "")
    | Missed -> (the, ", since the ray hits nothing")
    | Chain_ended -> (the, "")
  in
  describe film ~depth:e.left ~article (path e)
  ^ what ^ over_exposed film e.color

let sees film (e : Explain.t) =
  describe film ~depth:e.left ~article:the (path e)

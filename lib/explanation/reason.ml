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
    | Background | Emitted | Mirror _ | Refraction _ -> false)

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

(* What light went through, and what became of it. *)
let filtered (light, through) =
  let name { Explain.by; object_; place; _ } =
    (by, Naming.by_number by object_ place)
  in
  let names = List.sort_uniq compare (List.map name through) in
  let went =
    Printf.sprintf "light %d went through %s" light
      (Words.list (List.map snd names))
  and tint = Explain.tint through in
  match Color_word.hue tint with
  | Some _ ->
      let whole = Saturate.limit (1. /. Color.largest tint) in
      let bright = Saturate.color (Color.scale whole tint) in
      Printf.sprintf "in %s: %s"
        (Words.a (Color_word.of_color bright ^ " shadow"))
        went
  | None ->
      Printf.sprintf "in a weak shadow: %s, and %s of it came out" went
        (Words.rough_percent (Color.largest tint))

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
  and are_filtered =
    pick (fun { number; verdict; _ } ->
        match verdict with
        | Lit { through = _ :: _ as through; _ } -> Some (number, through)
        | _ -> None)
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
    @ List.map filtered are_filtered
    @ clause (shadows h) are_blocked
    @ faces_away h are_behind
  in
  if is_black h.lobes.albedo then []
  else if clauses = [] then [ "with no light in the scene" ]
  else if are_lit = [] then clauses @ [ "so that no light reaches it" ]
  else clauses

(* {1 What a ray meets} *)

let the phrase = "the " ^ phrase

(* Of several rays the one that brings most. *)
let main_ray (e : Explain.t) =
  let brighter best ({ color; ray; _ } : Explain.term) =
    match (ray, best) with
    | None, _ -> best
    | Some ray, Some (most, _) when Color.largest color <= most ->
        ignore ray;
        best
    | Some ray, _ -> Some (Color.largest color, ray)
  in
  Option.map snd (List.fold_left brighter None e.terms)

(* The way along these, without further hits of what lets light through: what
   goes into a glass ball comes out of it. *)
let rec path ?through (e : Explain.t) =
  let rest through =
    match main_ray e with None -> [] | Some next -> path ?through next
  in
  match e.outcome with
  | Missed | Chain_ended | Too_faint -> [ e ]
  | Hit { lobes = { refractions = []; _ }; _ } -> e :: rest None
  | Hit { hit; _ } when through = Some hit.number -> rest through
  | Hit { hit; _ } -> e :: rest (Some hit.number)

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
  | { outcome = Too_faint; color; _ } :: _ ->
      article (Naming.background color)
      ^ ", because the ray is too faint to follow"
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
  let is_clear = is_black h.lobes.albedo && is_black h.lobes.emission in
  match rest with
  | [] -> ""
  | first :: others -> (
      let is_mirrored (e : Explain.t) = e.role = Mirrored in
      let verb =
        if is_clear then " that shows"
        else if is_mirrored first then ", whose mirror shows"
        else ", through which shows"
      in
      match others with
      | [] | [ _ ] -> verb ^ " " ^ describe film ~depth ~article:the rest
      | _ ->
          let between = List.length others in
          Printf.sprintf "%s, by way of %d more %s, %s" verb between
            (if List.for_all is_mirrored rest then "mirrors" else "surfaces")
            (describe film ~depth ~article:the [ List.nth rest between ]))

let bent (e : Explain.t) =
  match e.outcome with
  | Missed | Chain_ended | Too_faint -> ""
  | Hit h ->
      String.concat "" (List.map (fun s -> "; " ^ s) (Bending.of_hit e h))

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
    | Chain_ended | Too_faint -> (the, "")
  in
  describe film ~depth:e.left ~article (path e)
  ^ what ^ bent e ^ over_exposed film e.color

let sees film (e : Explain.t) =
  describe film ~depth:e.left ~article:the (path e)

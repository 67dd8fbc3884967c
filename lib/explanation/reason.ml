open Raylab_scene
open Raylab_tracer

let is_black c = Color.equal c Color.black

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

let clauses ~exact film e (h : Explain.surface_hit) =
  if Lobes.is_none h.lobes then [ "which returns no light" ]
  else Illumination.clauses ~exact film e h

(* [describe ~exact film ~depth ~article path] is about the rays of [path], the last
   ones of a chain of at most [depth]. *)
let rec describe ~exact film ~depth ~article (path : Explain.t list) =
  match path with
  | ({ outcome = Hit h; _ } as e) :: rest ->
      let { Object.shape; _ } = Object.primitive h.object_ h.hit.primitive in
      let look =
        article
          (Naming.by_look ?primitive:h.primitive h.hit.number h.object_
             h.surface h.place)
        |> Naming.with_part shape h.hit.part
      in
      let clauses = clauses ~exact film e h in
      String.concat ", " (look :: clauses) ^ shows ~exact film ~depth h rest
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

and shows ~exact film ~depth h rest =
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
      | [] | [ _ ] ->
          verb ^ " " ^ describe ~exact film ~depth ~article:the rest
      | _ ->
          let between = List.length others in
          Printf.sprintf "%s, by way of %d more %s, %s" verb between
            (if List.for_all is_mirrored rest then "mirrors" else "surfaces")
            (describe ~exact film ~depth ~article:the
               [ List.nth rest between ]))

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
  describe ~exact:true film ~depth:e.left ~article (path e)
  ^ what ^ bent e ^ over_exposed film e.color

let sees film (e : Explain.t) =
  describe ~exact:false film ~depth:e.left ~article:the (path e)

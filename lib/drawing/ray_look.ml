open Raylab_scene

type ground = Paper | Picture

let ink ground (kind : Path.kind) =
  match (ground, kind) with
  | Paper, Primary -> 0x1565c0
  | Paper, (Mirrored | Unfollowed) -> 0x8e24aa
  | Paper, Refracted -> 0x00838f
  | Paper, Lit -> 0xe09000
  | Paper, Blocked -> 0xd32f2f
  | Picture, (Primary | Mirrored) -> 0x66e0ff
  | Picture, Refracted -> 0x5effb0
  | Picture, Unfollowed -> 0xc8a0ff
  | Picture, Lit -> 0xffe04a
  | Picture, Blocked -> 0xff5a4a

(* The ink for light of this tint, if it can be told from white. *)
let tinted ground tint kind =
  let most = Color.largest tint in
  let scale = Saturate.limit (1. /. most) in
  let { Color.r; g; b } = Saturate.color (Color.scale scale tint) in
  if Float.min r (Float.min g b) > 0.85 then ink ground kind
  else
    (* on paper not too bright *)
    let shown = match ground with Paper -> 0.8 | Picture -> 1. in
    let r, g, b = Color.to_bytes (Color.scale shown (Color.make r g b)) in
    (r lsl 16) lor (g lsl 8) lor b

let words ground (kind : Path.kind) =
  match (ground, kind) with
  | _, Primary -> "from the eye"
  | _, Unfollowed -> "not followed"
  | Paper, Refracted -> "refracted"
  | Picture, Refracted -> "refracted ray"
  | Paper, Mirrored -> "mirrored"
  | Paper, Lit -> "shadow ray to a light"
  | Paper, Blocked -> "shadow ray, blocked"
  | Picture, Mirrored -> "mirrored ray"
  | Picture, Lit -> "to a light"
  | Picture, Blocked -> "to a light, blocked"

let stroke ~tint ground kind =
  let width, dashes =
    match (ground, (kind : Path.kind)) with
    | Paper, (Primary | Mirrored | Refracted) -> (2.2, None)
    | Paper, Unfollowed -> (2.2, Some (2., 3.))
    | Paper, (Lit | Blocked) -> (1.6, Some (6., 4.))
    | Picture, (Primary | Mirrored | Refracted) -> (2., None)
    | Picture, (Unfollowed | Lit | Blocked) -> (1., Some (6., 4.))
  in
  { Drawing.ink = tinted ground tint kind; width; dashes }

let rim = 0x101010

(* The pens with which lines are drawn, one after the other. *)
let pens ground (pen : Drawing.stroke) =
  match ground with
  | Paper -> [ pen ]
  | Picture -> [ { pen with ink = rim; width = pen.width +. 2. }; pen ]

let lines ground pen ends =
  let draw pen = List.map (fun (a, b) -> Drawing.Line (pen, a, b)) ends in
  List.concat_map draw (pens ground pen)

let line ?(tint = Color.white) ground kind a b =
  lines ground (stroke ~tint ground kind) [ (a, b) ]

let cross ground (x, y) =
  let width = match ground with Paper -> 2.4 | Picture -> 2. in
  let arm d = ((x -. 5., y -. d), (x +. 5., y +. d)) in
  lines ground
    (Drawing.stroke ~width (ink ground Blocked))
    [ arm 5.; arm (-5.) ]

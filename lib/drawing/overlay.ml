open Raylab_scene

type line = {
  kind : Path.kind;
  tint : Color.t;
  ends : Drawing.point * Drawing.point;
}

type t = {
  lines : line list;
  hits : Drawing.point list;
  blocks : Drawing.point list;
}

let most_rays = 400

let make camera ~first_row { Path.rays; _ } =
  let rays = List.filteri (fun i _ -> i < most_rays) rays in
  let shift (x, y) = (x, y -. float_of_int first_row) in
  let line { Path.kind; ray; length; tint; _ } =
    match (kind, Camera.project_ray camera ray ~length) with
    | Primary, _ | _, None -> None
    | _, Some (a, b) -> Some { kind; tint; ends = (shift a, shift b) }
  and end_of ray =
    Option.map shift (Option.bind (Path.end_of ray) (Camera.project camera))
  and is_block { Path.kind; _ } = kind = Blocked
  and is_chain { Path.kind; _ } =
    match kind with
    | Primary | Mirrored | Refracted -> true
    | Unfollowed | Lit | Blocked -> false
  in
  {
    lines = List.filter_map line rays;
    hits = List.filter_map end_of (List.filter is_chain rays);
    blocks = List.filter_map end_of (List.filter is_block rays);
  }

let kinds { lines; _ } =
  List.filter
    (fun kind -> List.exists (fun line -> line.kind = kind) lines)
    [ Path.Mirrored; Refracted; Unfollowed; Lit; Blocked ]

(* {1 Drawing} *)

let line ~place window { kind; tint; ends = a, b } =
  match Clip.segment window (place a, place b) with
  | None -> []
  | Some (a, b) -> Ray_look.line ~tint Picture kind a b

let hit place =
  let disc ink radius =
    Drawing.Circle (Drawing.filled (Ink ink), place, radius)
  in
  [ disc Ray_look.rim 4.; disc (Ray_look.ink Picture Primary) 3. ]

(* A ring around the pixel. *)
let ring ~place window (x, y) =
  let corner dx dy = place (float_of_int (x + dx), float_of_int (y + dy)) in
  let left, top = corner 0 0 and right, bottom = corner 1 1 in
  let away = 6. in
  let left = left -. away and top = top -. away in
  let right = right +. away -. 1. and bottom = bottom +. away -. 1. in
  let sides =
    [
      ((left, top), (right, top));
      ((right, top), (right, bottom));
      ((right, bottom), (left, bottom));
      ((left, bottom), (left, top));
    ]
  in
  Ray_look.lines Picture
    (Drawing.stroke ~width:1. 0xffffff)
    (List.filter_map (Clip.segment window) sides)

let draw ~place window ~pixel { lines; hits; blocks } =
  let mark draw point =
    let point = place point in
    if Rectangle.contains window point then draw point else []
  in
  List.concat
    [
      List.concat_map (line ~place window) lines;
      List.concat_map (mark hit) hits;
      List.concat_map (mark (Ray_look.cross Picture)) blocks;
      ring ~place window pixel;
    ]

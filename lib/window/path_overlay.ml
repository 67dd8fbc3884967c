open Raylab_geometry
open Raylab_scene
open Raylab_drawing

type role = Mirrored | Not_followed | Lit | Blocked

let all_roles = [ Mirrored; Not_followed; Lit; Blocked ]

let color = function
  | Mirrored -> 0x66e0ff
  | Not_followed -> 0xc8a0ff
  | Lit -> 0xffe04a
  | Blocked -> 0xff5a4a

let is_dashed = function
  | Mirrored -> false
  | Not_followed | Lit | Blocked -> true

let name = function
  | Mirrored -> "mirrored ray"
  | Not_followed -> "not followed: the chain ended"
  | Lit -> "to a light"
  | Blocked -> "to a light, blocked"

type t = {
  lines : (role * Segment.t) list;
  hits : Segment.point list;
  blocks : Segment.point list;
}

let role : Path.kind -> role option = function
  | Primary -> None
  | Mirrored -> Some Mirrored
  | Unfollowed -> Some Not_followed
  | Lit -> Some Lit
  | Blocked -> Some Blocked

let most_rays = 400

let make camera ~first_row explanation =
  let shift (x, y) = (x, y -. float_of_int first_row) in
  let rays =
    let { Path.rays; _ } = Path.of_explanation explanation in
    List.of_seq (Seq.take most_rays (List.to_seq rays))
  in
  let line { Path.kind; ray; length; _ } =
    match (role kind, Camera.project_ray camera ray ~length) with
    | Some role, Some (a, b) -> Some (role, (shift a, shift b))
    | _ -> None
  and end_of { Path.ray; length; _ } =
    if length = infinity then None
    else Option.map shift (Camera.project camera (Ray.at ray length))
  in
  let is_block { Path.kind; _ } =
    match kind with
    | Blocked -> true
    | Primary | Mirrored | Unfollowed | Lit -> false
  and is_chain { Path.kind; _ } =
    match kind with
    | Primary | Mirrored -> true
    | Unfollowed | Lit | Blocked -> false
  in
  {
    lines = List.filter_map line rays;
    hits = List.filter_map end_of (List.filter is_chain rays);
    blocks = List.filter_map end_of (List.filter is_block rays);
  }

let roles { lines; _ } =
  List.filter (fun role -> List.mem_assoc role lines) all_roles

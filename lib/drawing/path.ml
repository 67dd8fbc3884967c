open Raylab_geometry
open Raylab_scene
open Raylab_tracer

type kind = Primary | Mirrored | Unfollowed | Lit of int | Blocked of int

type line = {
  kind : kind;
  ray : Ray.t;
  length : float;
  meets : (int * Object.t) option;
}

let shadow_line { Explain.number; verdict; _ } =
  match verdict with
  | Faces_away _ | Lit { shadow_ray = None; _ } -> None
  | Lit { shadow_ray = Some ray; _ } ->
      Some { kind = Lit number; ray; length = Ray.reach ray; meets = None }
  | Blocked { shadow_ray = ray; by; blocker; t; _ } ->
      let meets = Some (by, blocker) in
      Some { kind = Blocked number; ray; length = t; meets }

let rec lines_from (e : Explain.t) =
  let kind = match e.role with Primary -> Primary | Mirrored -> Mirrored in
  let endless kind =
    [ { kind; ray = e.ray; length = infinity; meets = None } ]
  in
  match e.outcome with
  | Missed -> endless kind
  | Chain_ended -> endless Unfollowed
  | Hit h ->
      let meets = Some (h.hit.number, h.object_) in
      { kind; ray = e.ray; length = h.hit.t; meets }
      :: List.filter_map shadow_line h.lights
      @ List.concat_map lines_from (Explain.next e)

let lines = lines_from

let rec hits (e : Explain.t) =
  match e.outcome with
  | Missed | Chain_ended -> []
  | Hit h -> (h, e.color) :: List.concat_map hits (Explain.next e)

let objects e =
  let met { meets; _ } = Option.map fst meets in
  List.sort_uniq Int.compare (List.filter_map met (lines e))

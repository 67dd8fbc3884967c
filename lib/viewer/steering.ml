open Raylab_scene

type asked = Scene | View

type t = {
  home : Camera.t option;  (** the scene's own *)
  moved : Viewpoint.t option;  (** by the hand *)
  asked : asked;  (** of the latest picture *)
  is_awaited : bool;  (** whether that is still to begin *)
  is_due : bool;  (** whether the eye is elsewhere than in it *)
}

let start =
  {
    home = None;
    moved = None;
    asked = Scene;
    is_awaited = true;
    is_due = false;
  }

let viewpoint { home; moved; _ } =
  match moved with
  | Some _ -> moved
  | None -> Option.map (fun (camera : Camera.t) -> camera.viewpoint) home

let ask s = { s with asked = Scene; is_awaited = true }
let is_view s = s.asked = View

let begin_ (camera : Camera.t) s =
  let s = { s with is_awaited = false } in
  match (s.asked, s.home) with
  | View, _ -> s
  | Scene, Some { viewpoint; _ }
    when Viewpoint.equal viewpoint camera.viewpoint ->
      { s with home = Some camera; is_due = Option.is_some s.moved }
  | Scene, _ -> { s with home = Some camera; moved = None; is_due = false }

let is_under_way s = s.is_due || (s.is_awaited && s.asked = View)
let fail s = { s with is_awaited = false; is_due = false }
let move viewpoint s = { s with moved = Some viewpoint; is_due = true }

let back s =
  if s.moved = None then s else { s with moved = None; is_due = true }

let camera { home; moved; _ } =
  match (home, moved) with
  | Some camera, Some viewpoint -> (
      (* the canvas may leave the range of numbers *)
      try Some (Camera.with_viewpoint viewpoint camera)
      with Invalid_argument _ -> None)
  | home, _ -> home

let next ~is_covered s =
  let is_ready = (not s.is_awaited) && (s.asked = Scene || is_covered) in
  if s.is_due && is_ready then
    match camera s with
    | None -> ({ s with is_due = false }, None)
    | Some _ as camera ->
        ({ s with asked = View; is_awaited = true; is_due = false }, camera)
  else (s, None)

open Raylab_scene
open Raylab_tracer

type t = { scene : Trace.t; refinement : Refinement.t; first_row : int }

let size shown = Refinement.size shown.refinement

let rec color some ~size:wanted ~x ~y =
  match some with
  | [] -> Drawing.background
  | shown :: others -> (
      let known =
        if size shown = wanted then Refinement.color shown.refinement ~x ~y
        else None
      in
      match known with
      | Some known -> known
      | None -> color others ~size:wanted ~x ~y)

let explain { scene; first_row; _ } (x, y) =
  Explain.pixel scene ~x ~y:(y + first_row)

let overlay { scene; first_row; _ } explanation =
  Path_overlay.make (Trace.scene scene).Scene.camera ~first_row explanation

open Raylab_scene
open Raylab_tracer
open Raylab_explanation
open Raylab_drawing

type t = { scene : Prepared.t; refinement : Refinement.t; first_row : int }

let background = 0x202428
let size shown = Refinement.size shown.refinement

let look some =
  (* those from the first on that knows the pixel *)
  let rec from_known some ~x ~y =
    match some with
    | r :: others when Refinement.step r ~x ~y = 0 -> from_known others ~x ~y
    | some -> some
  in
  let some = List.map (fun shown -> shown.refinement) some in
  let step ~x ~y =
    match from_known some ~x ~y with
    | [] -> 0
    | r :: _ -> Refinement.step r ~x ~y
  and color ~x ~y =
    match from_known some ~x ~y with
    | [] -> background
    | r :: _ -> Refinement.color r ~x ~y
  in
  { Raster.step; color }

let explain { scene; first_row; _ } (x, y) =
  Explain.pixel scene ~x ~y:(y + first_row)

let overlay { scene; first_row; _ } explanation =
  let { Scene.camera; film; _ } = scene.Prepared.scene in
  Overlay.make camera ~first_row (Path.of_rays film (Group.rays explanation))

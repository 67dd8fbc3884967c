open Raylab_scene
open Written

type t = {
  width : int option;
  height : int option;
  canvas_width : float option;
  canvas_height : float option;
  depth : float option;
  ray_depth : int option;
  background : Color.t option;
}

type change = (t -> t) Written.t

let none =
  {
    width = None;
    height = None;
    canvas_width = None;
    canvas_height = None;
    depth = None;
    ray_depth = None;
    background = None;
  }

let required : string list =
  [ "imWidth"; "imHeight"; "canvWidth"; "canvHeight"; "depth" ]

let scene s ~files ~lights ~objects =
  match s with
  | {
   width = Some width;
   height = Some height;
   canvas_width = Some canvas_width;
   canvas_height = Some canvas_height;
   depth = Some depth;
   ray_depth;
   background;
  } ->
      let camera =
        Camera.make ~width ~height ~canvas_width ~canvas_height ~depth
      in
      Scene.make camera ?background ?ray_depth ~files ~lights ~objects
  | _ -> invalid_arg "Settings.scene: a setting is missing"

(* {1 Words} *)

let sets parameter make = Written { make; parameters = [ parameter ] }
let size = whole ~least:1 ~most:Camera.max_size
let length = number Positive
let im_width e = sets (size "imWidth" e) (fun n s -> { s with width = Some n })

let im_height e =
  sets (size "imHeight" e) (fun n s -> { s with height = Some n })

let canv_width e =
  sets (length "canvWidth" e) (fun x s -> { s with canvas_width = Some x })

let canv_height e =
  sets (length "canvHeight" e) (fun x s -> { s with canvas_height = Some x })

let depth e = sets (length "depth" e) (fun x s -> { s with depth = Some x })

let raydepth e =
  sets (whole ~least:0 ~most:Scene.max_ray_depth "raydepth" e) (fun n s ->
      { s with ray_depth = Some n })

let bcolor e =
  sets (color "bcolor" e) (fun c s -> { s with background = Some c })

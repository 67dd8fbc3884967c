open Raylab_geometry
open Raylab_scene
open Written

type t = {
  width : int option;
  height : int option;
  canvas_width : float option;
  canvas_height : float option;
  depth : float option;
  fov : float option;
  eye : Vec3.t option;
  look_at : Vec3.t option;
  up : Vec3.t option;
  ray_depth : int option;
  background : Background.t option;
  ambient : Color.t option;
  film : Film.t;
  aperture : float;
  focus : float option;
}

type change = (t -> t) Written.t

let none =
  {
    width = None;
    height = None;
    canvas_width = None;
    canvas_height = None;
    depth = None;
    fov = None;
    eye = None;
    look_at = None;
    up = None;
    ray_depth = None;
    background = None;
    ambient = None;
    film = Film.default;
    aperture = 0.;
    focus = None;
  }

let viewpoint { depth; eye; look_at; up; _ } =
  let usual depth = (Viewpoint.before_origin depth).eye in
  let eye = if Option.is_some eye then eye else Option.map usual depth in
  Option.map (Viewpoint.make ?look_at ?up) eye

let camera s =
  match (s, viewpoint s) with
  | ( { width = Some width; height = Some height; fov = Some fov; _ },
      Some (Ok viewpoint) ) ->
      Some (Camera.of_fov ~width ~height ~fov viewpoint)
  | ( {
        width = Some width;
        height = Some height;
        canvas_width = Some canvas_width;
        canvas_height = Some canvas_height;
        depth = Some depth;
        _;
      },
      Some (Ok viewpoint) ) ->
      Some
        (Camera.make ~width ~height ~canvas_width ~canvas_height ~depth
        |> Camera.with_viewpoint viewpoint)
  | _ -> None

let scene s ~files ~lights ~objects =
  let { background; ambient; ray_depth; film; aperture; focus; _ } = s in
  let lens = Lens.make ?focus aperture in
  match camera s with
  | Some camera ->
      let scene =
        Scene.make camera ~film ~lens ?ambient ?ray_depth ~files ~lights
          ~objects
      in
      Option.fold background ~none:scene ~some:(fun background ->
          Scene.with_sky background scene)
  | None -> invalid_arg "Settings.scene: no camera"

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

let fov e =
  sets (number Positive "fov" e) (fun x ->
      if x >= 180. then refuse "fov must be less than 180 degrees"
      else fun s -> { s with fov = Some x })

let eye e = sets (vector "eye" e) (fun v s -> { s with eye = Some v })

let look_at e =
  sets (vector "lookAt" e) (fun v s -> { s with look_at = Some v })

let up e = sets (direction "up" e) (fun v s -> { s with up = Some v })

let raydepth e =
  sets (whole ~least:0 ~most:Scene.max_ray_depth "raydepth" e) (fun n s ->
      { s with ray_depth = Some n })

let bcolor e =
  sets (color "bcolor" e) (fun c s ->
      { s with background = Some (Background.plain c) })

let bcolor_varying point e =
  sets (pattern point "bcolor" e) (fun pattern s ->
      { s with background = Some (Background.varying pattern) })

let ambient e =
  sets (color "ambient" e) (fun c s -> { s with ambient = Some c })

let change_film with_ value s = { s with film = with_ value s.film }

let samples e =
  sets
    (whole ~least:1 ~most:Film.max_samples "samples" e)
    (change_film Film.with_samples)

let exposure e =
  sets (number Positive "exposure" e) (change_film Film.with_exposure)

let srgb = Written { make = change_film Film.with_srgb true; parameters = [] }

let aperture e =
  sets (number Non_negative "aperture" e) (fun x s -> { s with aperture = x })

let focus e = sets (length "focus" e) (fun x s -> { s with focus = Some x })

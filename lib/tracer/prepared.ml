open Raylab_geometry
open Raylab_scene

type clear = { numbers : int array; index : Index.t }

type t = {
  scene : Scene.t;
  centres : Camera.centres;
  lights : Light.t array;
  objects : Object.t array;
  shapes : Shape.t array;
  surfaces : Surfaces.t;
  index : Index.t;
  casters : int array option;
  shadow_index : Index.t;
  clear : clear option;
  shadowless : int array;
  offset : float;
}

let usual_offset (scene : Scene.t) =
  Offset.of_scale (Camera.scale scene.camera)

(* The numbers of those for which it holds. *)
let numbers_of objects holds =
  Array.to_seqi objects
  |> Seq.filter (fun (_, o) -> holds o)
  |> Seq.map fst |> Array.of_seq

let is_shadowless (o : Object.t) = o.is_shadowless
let is_clear o = (not (is_shadowless o)) && Glasses.lets_through o
let ends_light o = not (is_shadowless o || is_clear o)

(* Those that end shadow rays, if they are not all. *)
let casters_of objects =
  if Array.for_all ends_light objects then None
  else Some (numbers_of objects ends_light)

let make ?(domains = 1) ?(index = Index.hierarchy ~domains) (scene : Scene.t) =
  let objects = Array.of_list scene.objects in
  let offset = Offset.of_scale (Camera.scale scene.camera) in
  let shape (o : Object.t) = Shape.with_tolerance offset o.shape in
  let shapes = Array.map shape objects in
  let casters = casters_of objects and whole_index = index shapes in
  let index_of numbers = index (Array.map (fun k -> shapes.(k)) numbers) in
  let clear numbers =
    if numbers = [||] then None else Some { numbers; index = index_of numbers }
  in
  {
    scene;
    centres = Camera.centres scene.camera;
    lights = Array.of_list scene.lights;
    objects;
    shapes;
    surfaces = Surfaces.make objects;
    index = whole_index;
    casters;
    shadow_index =
      (match casters with
      | None -> whole_index
      | Some numbers -> index_of numbers);
    clear = clear (numbers_of objects is_clear);
    shadowless = numbers_of objects is_shadowless;
    offset;
  }

(* {1 Many rays} *)

let eye_source { Scene.camera; lens; film; _ } =
  if film.samples > 1 && Lens.is_open lens then None
  else Some (Camera.fan camera)

(* A fan of one shape takes as long as two or three rays; a primary ray brings
   about as many shadow rays as there are lights. *)
let pays t ~rays = 2 * Array.length t.objects <= rays

let for_many_rays ?domains ~rays t =
  let eye = eye_source t.scene and lights = Array.map Light.fan t.lights in
  if not (pays t ~rays) then t
  else
    match t.casters with
    | None ->
        let index = Index.for_many_rays ?domains ?eye ~lights t.index in
        { t with index; shadow_index = index }
    | Some _ ->
        {
          t with
          index = Index.for_many_rays ?domains ?eye ~lights:[||] t.index;
          shadow_index = Index.for_many_rays ?domains ~lights t.shadow_index;
        }

let with_camera camera t =
  let scene = Scene.with_camera camera t.scene in
  {
    t with
    scene;
    centres = Camera.centres camera;
    offset = usual_offset scene;
  }

let caster t place =
  match t.casters with None -> place | Some numbers -> numbers.(place)

let clear_number t place =
  match t.clear with None -> place | Some { numbers; _ } -> numbers.(place)

let primitive t ~number ~part =
  match t.shapes.(number) with
  | Solid s -> Some (Solid.member_of s ~part + 1)
  | _ -> None

let own_part t ~number ~part =
  match t.shapes.(number) with Solid s -> Solid.own_part s ~part | _ -> part

let surface t ~number ~part =
  (Object.primitive t.objects.(number) (primitive t ~number ~part)).surface

let row t ~number ~part =
  match t.shapes.(number) with
  | Solid s -> t.surfaces.primitive_rows.(number).(Solid.member_of s ~part)
  | _ -> t.surfaces.rows.(number)

let numbered_object t number = t.objects.(number - 1)
let numbered_light t number = t.lights.(number - 1)

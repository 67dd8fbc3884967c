open Raylab_geometry
open Raylab_scene

type t = {
  scene : Scene.t;
  centres : Camera.centres;
  lights : Light.t array;
  objects : Object.t array;
  shapes : Shape.t array;
  surfaces : Surfaces.t;
  index : Finder.index;
  casters : int array option;
  shadow_index : Finder.index;
  offset : float;
}

let usual_offset (scene : Scene.t) =
  Offset.of_scale (Camera.scale scene.camera)

(* Those that shadow rays meet, if they are not all. *)
let casters_of objects =
  if Array.exists (fun (o : Object.t) -> o.is_shadowless) objects then
    let casts (_, (o : Object.t)) = not o.is_shadowless in
    Array.to_seqi objects |> Seq.filter casts |> Seq.map fst |> Array.of_seq
    |> Option.some
  else None

let make ?(domains = 1) ?(index = Bvh.index ~domains) (scene : Scene.t) =
  let objects = Array.of_list scene.objects in
  let offset = Offset.of_scale (Camera.scale scene.camera) in
  let shape (o : Object.t) = Shape.with_tolerance offset o.shape in
  let shapes = Array.map shape objects in
  let casters = casters_of objects and whole_index = index shapes in
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
      | Some numbers -> index (Array.map (fun k -> shapes.(k)) numbers));
    offset;
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

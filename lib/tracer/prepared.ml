open Raylab_geometry
open Raylab_scene

type t = {
  scene : Scene.t;
  centres : Camera.centres;
  lights : Light.t array;
  objects : Object.t array;
  shapes : Shape.t array;
  lobes : float array;
  rows : int array;
  primitive_rows : int array array;
  levels : int;
  index : Finder.index;
  casters : int array option;
  shadow_index : Finder.index;
  offset : float;
}

let varies = -1
let of_primitives = -2

(* Gives each surface a row, and shows [visit] those that do not vary. Surfaces
   that are one, one after another, share a row. *)
let rows_of objects ~visit =
  let last = ref None and stop = ref 0 in
  let new_row surface =
    if Surface.varies surface then varies
    else
      let row = !stop in
      visit surface row;
      stop := row + Raw_lobes.size;
      row
  in
  let row (o : Object.t) =
    match !last with
    | Some (surface, row) when surface == o.surface -> row
    | _ ->
        let row = new_row o.surface in
        last := Some (o.surface, row);
        row
  in
  let object_ (o : Object.t) =
    match o.primitives with
    | [||] -> (row o, [||])
    | primitives -> (of_primitives, Array.map row primitives)
  in
  let all = Array.map object_ objects in
  (all, !stop / Raw_lobes.size)

(* A mix is worked out beyond the end of its row. *)
let write_lobes objects count ~levels =
  let lobes = Raw_lobes.create ~rows:(count + levels - 1)
  and nowhere = Spot.create () in
  let visit surface row = Surface.write surface nowhere lobes row in
  ignore (rows_of objects ~visit);
  lobes

let deepest objects =
  let deeper levels surface = Int.max levels (Surface.levels surface) in
  Array.fold_left
    (fun levels o -> List.fold_left deeper levels (Object.surfaces o))
    1 objects

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
  let shapes = Array.map shape objects
  and levels = deepest objects
  and all_rows, count = rows_of objects ~visit:(fun _ _ -> ()) in
  let casters = casters_of objects and whole_index = index shapes in
  {
    scene;
    centres = Camera.centres scene.camera;
    lights = Array.of_list scene.lights;
    objects;
    shapes;
    lobes = write_lobes objects count ~levels;
    rows = Array.map fst all_rows;
    primitive_rows =
      (if Array.exists (fun (row, _) -> row = of_primitives) all_rows then
         Array.map snd all_rows
       else [||]);
    levels;
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

let surface t ~number ~part =
  (Object.primitive t.objects.(number) (primitive t ~number ~part)).surface

let row t ~number ~part =
  match t.shapes.(number) with
  | Solid s -> t.primitive_rows.(number).(Solid.member_of s ~part)
  | _ -> t.rows.(number)

let numbered_object t number = t.objects.(number - 1)
let numbered_light t number = t.lights.(number - 1)

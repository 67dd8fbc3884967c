open Raylab_geometry
open Raylab_scene

type t = {
  scene : Scene.t;
  lights : Light.t array;
  objects : Object.t array;
  shapes : Shape.t array;
  lobes : float array;
  rows : int array;
  levels : int;
  index : Finder.index;
  offset : float;
}

let varies = -1

(* Objects that are written with one surface, one after another, share a row. *)
let place_surfaces objects =
  let last = ref None and stop = ref 0 in
  let row_of (o : Object.t) =
    match !last with
    | Some (surface, row) when surface == o.surface -> row
    | _ ->
        let row = if Surface.varies o.surface then varies else !stop in
        if row <> varies then stop := !stop + Raw_lobes.size;
        last := Some (o.surface, row);
        row
  in
  let rows = Array.map row_of objects in
  (rows, !stop / Raw_lobes.size)

(* A mix is worked out beyond the end of its row. *)
let write_lobes objects rows count ~levels =
  let lobes = Raw_lobes.create ~rows:(count + levels - 1)
  and nowhere = Spot.create () in
  Array.iteri
    (fun k row ->
      if row <> varies && (k = 0 || row <> rows.(k - 1)) then
        Surface.write objects.(k).Object.surface nowhere lobes row)
    rows;
  lobes

let deepest objects =
  Array.fold_left
    (fun levels (o : Object.t) -> Int.max levels (Surface.levels o.surface))
    1 objects

let usual_offset (scene : Scene.t) =
  Offset.of_scale (Camera.scale scene.camera)

let make ?(domains = 1) ?(index = Bvh.index ~domains) (scene : Scene.t) =
  let objects = Array.of_list scene.objects in
  let shapes = Array.map (fun (o : Object.t) -> o.shape) objects
  and levels = deepest objects
  and rows, count = place_surfaces objects in
  {
    scene;
    lights = Array.of_list scene.lights;
    objects;
    shapes;
    lobes = write_lobes objects rows count ~levels;
    rows;
    levels;
    index = index shapes;
    offset = usual_offset scene;
  }

let with_camera camera t =
  let scene = Scene.with_camera camera t.scene in
  { t with scene; offset = usual_offset scene }

let numbered_object t number = t.objects.(number - 1)
let numbered_light t number = t.lights.(number - 1)

open Raylab_parallel
open Raylab_scene

type rows = { first : int; last : int }

let camera scene = (Trace.scene scene).Scene.camera
let all_rows scene = { first = 0; last = (camera scene).height - 1 }

let size ?rows scene =
  let all = all_rows scene in
  let { first; last } = Option.value rows ~default:all in
  if first < 0 || last < first || last > all.last then
    invalid_arg (Printf.sprintf "rows %d to %d of a picture" first last);
  ((camera scene).width, last - first + 1)

let blank ?rows scene =
  let width, height = size ?rows scene in
  Picture.create ~width ~height

(* Fills [picture], which shows [rows], pass by pass and tile by tile. *)
let fill ~domains ?stop ?on_progress ?rows ~passes ~on_tile picture scene =
  let first_row = match rows with None -> 0 | Some { first; _ } -> first in
  let width = Picture.width picture and height = Picture.height picture in
  let tiles = Tile.count ~width ~height in
  let stopped = Option.value stop ~default:(fun () -> false) in
  let work evaluator k =
    let pass = passes.(k / tiles)
    and tile = Tile.nth ~width ~height (k mod tiles) in
    Pass.iter pass tile (fun ~x ~y ->
        if not (stopped ()) then
          Picture.set picture ~x ~y
            (Evaluator.pixel evaluator ~x ~y:(first_row + y)));
    if not (stopped ()) then on_tile pass tile
  in
  Parallel.iter ~domains ?stop ?on_progress
    ~count:(Array.length passes * tiles)
    ~worker:(fun () -> Trace.evaluator scene)
    work
  |> List.map Evaluator.tally |> Tally.sum

let picture ?(domains = Parallel.default_domains ()) ?rows
    ?(on_progress = ignore) scene =
  let picture = blank ?rows scene in
  let count =
    Tile.count ~width:(Picture.width picture) ~height:(Picture.height picture)
  in
  let tally =
    fill ~domains ?rows picture scene
      ~on_progress:(fun n ->
        on_progress (float_of_int n /. float_of_int count))
      ~passes:[| Pass.whole |]
      ~on_tile:(fun _ _ -> ())
  in
  on_progress 1.;
  (picture, tally)

let refine ?(domains = Parallel.default_domains ()) ?rows ?stop ~on_tile
    picture scene =
  if size ?rows scene <> (Picture.width picture, Picture.height picture) then
    invalid_arg "a picture of another size";
  fill ~domains ?rows ?stop picture scene ~passes:Pass.coarse_to_fine ~on_tile

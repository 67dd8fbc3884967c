open Raylab_parallel
open Raylab_scene

type rows = { first : int; last : int }

let camera scene = (Trace.scene scene).Scene.camera
let all_rows scene = { first = 0; last = (camera scene).height - 1 }

(* Neighbouring pixels meet the same objects, which a square tile keeps in the
   cache. *)
let tile_side = 16
let tiles length = (length + tile_side - 1) / tile_side

let fill_tile picture ~first_row evaluator number =
  let width = Picture.width picture and height = Picture.height picture in
  let left = number mod tiles width * tile_side
  and top = number / tiles width * tile_side in
  for y = top to Int.min height (top + tile_side) - 1 do
    for x = left to Int.min width (left + tile_side) - 1 do
      Picture.set picture ~x ~y
        (Evaluator.pixel evaluator ~x ~y:(first_row + y))
    done
  done

let picture ?(domains = Parallel.default_domains ()) ?rows
    ?(on_progress = ignore) scene =
  let all = all_rows scene in
  let { first; last } = Option.value rows ~default:all in
  if first < 0 || last < first || last > all.last then
    invalid_arg (Printf.sprintf "rows %d to %d of a picture" first last);
  let picture =
    Picture.create ~width:(camera scene).width ~height:(last - first + 1)
  in
  let count = tiles (Picture.width picture) * tiles (Picture.height picture) in
  let evaluators =
    Parallel.iter ~domains ~count
      ~worker:(fun () -> Trace.evaluator scene)
      ~on_progress:(fun n -> on_progress (float_of_int n /. float_of_int count))
      (fill_tile picture ~first_row:first)
  in
  on_progress 1.;
  (picture, Tally.sum (List.map Evaluator.tally evaluators))

open Raylab_parallel
open Raylab_scene

type rows = { first : int; last : int }

let camera scene = scene.Prepared.scene.camera
let all_rows scene = { first = 0; last = (camera scene).height - 1 }

let size ?rows scene =
  let all = all_rows scene in
  let { first; last } = Option.value rows ~default:all in
  if first < 0 || last < first || last > all.last then
    invalid_arg (Printf.sprintf "rows %d to %d of a picture" first last);
  ((camera scene).width, last - first + 1)

let blank ?rows scene =
  let width, height = size ?rows scene in
  Picture.unset ~width ~height

(* Fills [picture], which shows [rows], pass by pass and tile by tile. *)
let fill ~domains ?stop ?on_progress ?rows ~passes ~on_tile picture scene =
  let film = scene.Prepared.scene.film in
  let first_row = match rows with None -> 0 | Some { first; _ } -> first in
  let width = Picture.width picture and height = Picture.height picture in
  let counts = Array.map (Pass.count ~width ~height) passes in
  (* tiles are numbered through all passes *)
  let rec nth p k =
    if k < counts.(p) then (passes.(p), Pass.nth passes.(p) ~width ~height k)
    else nth (p + 1) (k - counts.(p))
  in
  let stopped = Option.value stop ~default:(fun () -> false) in
  let work sampler k =
    let pass, tile = nth 0 k in
    let color =
      if Pass.is_smooth pass then (
        Sampler.prepare ?stop sampler { tile with top = first_row + tile.top };
        Sampler.pixel)
      else if film.samples = 1 then Sampler.pixel
      else Sampler.centre
    in
    Pass.iter pass tile (fun ~x ~y ->
        if not (stopped ()) then
          Picture.set picture ~x ~y
            (Film.encode film (color sampler ~x ~y:(first_row + y))));
    if not (stopped ()) then on_tile pass tile
  in
  Parallel.iter ~domains ?stop ?on_progress
    ~count:(Array.fold_left ( + ) 0 counts)
    ~worker:(fun () -> Sampler.create scene)
    work
  |> List.map Sampler.tally |> Tally.sum

(* Made ready for all rays of the picture. *)
let for_many_rays ~domains picture scene =
  let rays = Picture.width picture * Picture.height picture in
  Prepared.for_many_rays ~domains ~rays scene

let has_samples scene = scene.Prepared.scene.film.samples > 1

let picture ?(domains = Parallel.default_domains ()) ?rows
    ?(on_progress = ignore) scene =
  let picture = blank ?rows scene in
  let scene = for_many_rays ~domains picture scene in
  let pass = if has_samples scene then Pass.smooth else Pass.whole in
  let count =
    Pass.count pass ~width:(Picture.width picture)
      ~height:(Picture.height picture)
  in
  let tally =
    fill ~domains ?rows picture scene
      ~on_progress:(fun n ->
        on_progress (float_of_int n /. float_of_int count))
      ~passes:[| pass |]
      ~on_tile:(fun _ _ -> ())
  in
  on_progress 1.;
  (picture, tally)

let passes picture scene =
  let width = Picture.width picture and height = Picture.height picture in
  if has_samples scene then
    Array.append (Pass.coarse_to_smooth ~width ~height) [| Pass.smooth |]
  else Pass.coarse_to_fine ~width ~height

let refine ?(domains = Parallel.default_domains ()) ?rows ?stop ~on_tile
    picture scene =
  let size = size ?rows scene in
  if size <> (Picture.width picture, Picture.height picture) then
    invalid_arg "a picture of another size";
  let fill scene passes =
    fill ~domains ?rows ?stop picture scene ~on_tile
      ~passes:(Array.of_list passes)
  and is_stopped () =
    Option.fold stop ~none:false ~some:(fun stop -> stop ())
  in
  (* a centre must not come after all samples of its pixel *)
  let smooth, coarse =
    List.partition Pass.is_smooth (Array.to_list (passes picture scene))
  in
  (* the coarsest at once *)
  let coarsest, finer = (List.hd coarse, List.tl coarse) in
  let first = fill scene [ coarsest ] in
  let scene =
    if is_stopped () then scene else for_many_rays ~domains picture scene
  in
  let second = fill scene finer in
  Tally.sum [ first; second; fill scene smooth ]

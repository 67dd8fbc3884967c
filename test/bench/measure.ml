open Raylab_language
open Raylab_tracer

type t = {
  load : Child.clock;
  build : Child.clock;
  render : Child.clock;
  tally : Tally.t;
  words : float;
  peak : float option;
  picture : Digest.t;
}

(* Words allocated so far. [Gc.quick_stat] sums up what all domains have
   allocated, terminated ones included, but knows of a running domain only what
   it had allocated at its last minor collection. So one is made first. *)
let allocated () =
  Gc.minor ();
  let { Gc.minor_words; major_words; promoted_words; _ } = Gc.quick_stat () in
  minor_words +. major_words -. promoted_words

let peak_memory () =
  let high_water line =
    try Some (Scanf.sscanf line "VmHWM: %f kB" (fun kb -> kb *. 1024.))
    with Scanf.Scan_failure _ | End_of_file -> None
  in
  try
    In_channel.with_open_text "/proc/self/status" In_channel.input_all
    |> String.split_on_char '\n' |> List.find_map high_water
  with Sys_error _ -> None

let measured ~domains path () =
  let access = Raylab_disk.Disk.access in
  let loaded, load = Child.timed (fun () -> Scene_file.load ~access path) in
  match loaded with
  | Error _ -> failwith (path ^ " is not a scene")
  | Ok scene ->
      let prepared, build = Child.timed (fun () -> Prepared.make scene) in
      let before = allocated () in
      let (picture, tally), render =
        Child.timed (fun () -> Render.picture ~domains prepared)
      in
      let words = allocated () -. before in
      {
        load;
        build;
        render;
        tally;
        words;
        peak = peak_memory ();
        picture = Digest.bytes (Picture.to_rgb picture);
      }

let run ~domains path = Child.compute (measured ~domains path)
let rays run = float_of_int (Tally.rays run.tally)

let first_pixel () =
  Child.run Place.raylab
    [ "render"; Place.first_scene; "--rows"; "0-0"; "-q"; "-o"; "-" ]
  |> Result.map (fun ({ clock; _ } : Child.outcome) -> clock.wall)

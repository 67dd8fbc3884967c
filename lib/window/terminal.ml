open Raylab_tracer
open Raylab_explanation

type t = {
  print : string -> unit;
  tell : string -> unit;
  explain : Explain.pixel -> unit;
}

let write channel text =
  try
    output_string channel text;
    flush channel
  with Sys_error _ -> close_out_noerr channel

let make channel ~tell =
  let swatches =
    let descriptor = Unix.descr_of_out_channel channel in
    Swatch.detect ~is_terminal:(Unix.isatty descriptor) Sys.getenv_opt
  in
  {
    print = (fun text -> write channel (text ^ "\n"));
    tell;
    explain =
      (fun pixel ->
        let pp ppf = Report.pp_pixel_with ~swatches ppf in
        write channel (Format.asprintf "%a@.@." pp pixel));
  }

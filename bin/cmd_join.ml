open Cmdliner
open Raylab_picture
open Raylab_band

let or_write_error = function
  | Ok () -> ()
  | Error message -> Command.write_error message

let or_refuse = function
  | Ok value -> value
  | Error messages -> Command.refuse messages

let save join format out ~quiet =
  Signals.for_readers (fun () -> Join.save join format ~path:out)
  |> Result.map (fun outcome ->
         if not quiet then
           Command.say "%s" (Atomic_file.wrote ~path:out outcome))

let join parts out wanted quiet () =
  let to_output = Target.is_standard_output out in
  let files = or_refuse (Join.files parts) in
  let format =
    Output.format ?wanted out ~inputs:files ~named:"one of the bands"
  in
  or_write_error
    (if to_output then Atomic_file.check_output ()
     else Atomic_file.check ~path:out ~bytes:1);
  let join = or_refuse (Join.check files) in
  let { Band.width; height; _ } = Join.whole join in
  or_write_error (Picture_file.check_format format ~width ~height);
  let written =
    if to_output then
      Signals.for_readers (fun () -> Join.output join format stdout)
    else save join format out ~quiet
  in
  match written with
  | Ok () -> ()
  | Error (Unreadable message) -> Command.refuse [ message ]
  | Error (Unwritable message) -> Command.write_error message

let parts =
  let doc =
    "The files of the bands, which $(b,raylab render --rows) wrote, in any \
     order and format. A folder stands for all files in it, but for those \
     whose names start with a dot."
  in
  Arg.(non_empty & pos_all string [] & info [] ~docv:"PART" ~doc)

let out =
  let doc =
    "Write the picture to $(docv), whose extension says in which format: \
     $(b,.bmp), $(b,.png) or $(b,.ppm); without extension, and on standard \
     output, which is $(b,-), it is BMP, or what $(b,--format) says. A \
     picture that is already there is replaced."
  in
  Arg.(
    required & opt (some string) None & info [ "o"; "output" ] ~docv:"OUT" ~doc)

let quiet =
  let doc = "Do not print where the picture went." in
  Arg.(value & flag & info [ "q"; "quiet" ] ~doc)

let cmd =
  let man =
    [
      `S Manpage.s_description;
      `P
        "Puts bands together, and writes the picture that $(b,raylab render) \
         would have written at once, byte for byte. It appears whole or not \
         at all.";
      `P
        "Every band says in its file where it belongs and what it is part of, \
         and has a checksum. Nothing is written, and what is wrong is told, \
         if rows are missing, files are damaged, bands are of another scene, \
         size, colour or version of raylab, or bands overlap and differ. \
         Bands that overlap and agree may be given.";
      `P
        "The bands are read piece by piece, whatever their size. Memory is \
         needed for a whole band only if it is a PNG, and for the whole \
         picture only if $(i,OUT) is a PNG.";
    ]
  in
  Cmd.v
    (Command.info "join" ~doc:"put bands of a picture together" man)
    (Command.run Term.(const join $ parts $ out $ Output.wanted $ quiet))

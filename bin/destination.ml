open Raylab_picture
open Raylab_band

type t = Standard_output | File of string

let of_path path =
  if Target.is_standard_output path then Standard_output else File path

let or_write_error = function
  | Ok value -> value
  | Error message -> Command.write_error message

let check format destination ~width ~height =
  or_write_error (Picture_file.check_size format ~width ~height);
  or_write_error
    (match destination with
    | Standard_output -> Atomic_file.check_output ()
    | File path -> Picture_file.check format ~path ~width ~height)

let write_to_output format band picture =
  match band with
  | None -> Picture_file.output format stdout picture
  | Some band -> Band_writer.output format stdout band picture

let write_to_file format path band picture =
  match band with
  | None -> Picture_file.save format ~path picture
  | Some band -> Band_writer.save format ~path band picture

let write ~quiet format destination band picture =
  let written write =
    or_write_error (Signals.for_readers (fun () -> write band picture))
  in
  match destination with
  | Standard_output -> written (write_to_output format)
  | File path ->
      let outcome = written (write_to_file format path) in
      if not quiet then Command.say "%s" (Atomic_file.wrote ~path outcome)

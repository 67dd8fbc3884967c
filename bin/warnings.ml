open Raylab_source
open Raylab_scene
open Raylab_language

let print path reading =
  List.iter (fun warning ->
      Command.line "%s: warning: %s" (Printable.text path)
        (Warning.to_string (Scene_file.provenance reading) warning))

let tell path reading = print path reading (Scene_file.findings reading)

let tell_as view path reading =
  match reading.Scene_file.scene with
  | Error _ -> tell path reading
  | Ok written -> (
      let shown = Options.adjust_colored view written in
      let findings = Scene_file.findings { reading with scene = Ok shown } in
      match Options.distortion view written with
      | None -> print path reading findings
      | Some text ->
          (* which says more than what is found of the size *)
          let said = Proportions.warnings shown.camera in
          print path reading
            (List.filter (fun one -> not (List.mem one said)) findings);
          Command.say "warning: %s" text)

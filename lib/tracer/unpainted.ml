open Raylab_source
open Raylab_scene

exception Found of string list

let raise_ (prepared : Prepared.t) ?pixel (failure : Pattern.failure) =
  let files = prepared.scene.files in
  let message, lines = Pattern.told files ?pixel failure in
  let place =
    match Files.place files failure.fault.span.start with
    | Some place -> Place.to_string place ^ ": "
    | None -> ""
  in
  raise (Found ((place ^ message) :: lines))

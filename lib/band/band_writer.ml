open Raylab_tracer
open Raylab_picture

let label band picture =
  if
    (Picture.width picture, Picture.height picture)
    <> (band.Band.whole.width, Band.rows band)
  then invalid_arg "Band_writer: the picture is not of the band's size";
  let crc = Crc32.add_bytes (Band.checksum band) (Picture.to_rgb picture) in
  Band.label band crc

let pixels band picture =
  let label = Some (label band picture) in
  { (Pixels.of_picture picture) with label }

let save format ~path band picture =
  Picture_file.save_pixels format ~path (pixels band picture)

let output format channel band picture =
  Picture_file.output_pixels format channel (pixels band picture)

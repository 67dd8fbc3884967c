open Raylab_tracer
open Raylab_picture

let label band picture =
  if
    (Picture.width picture, Picture.height picture)
    <> (band.Band.whole.width, Band.rows band)
  then invalid_arg "Band_writer: the picture is not of the band's size";
  let crc = Crc32.add_bytes (Band.checksum band) (Picture.to_rgb picture) in
  Band.label band crc

let write_uncompressed format band picture path =
  let { Band.whole = { width; _ }; first; last } = band in
  let rows = Rows.of_bytes ~width ~top:first (Picture.to_rgb picture) in
  Uncompressed.write format ~label:(label band picture) ~width
    ~height:(Band.rows band)
    (fun ~lowest_first emit ->
      Rows.iter ~lowest_first ~width ~first ~last (fun ~first:_ -> emit) rows)
    path

let write_png band picture path =
  let label = label band picture in
  Picture_file.write Png picture path;
  let png = In_channel.with_open_bin path In_channel.input_all in
  Out_channel.with_open_bin path (fun channel ->
      output_string channel (Png_label.insert label png);
      (* closing would not tell of a full disk *)
      flush channel)

let write = function
  | Picture_file.Bmp -> write_uncompressed Bmp
  | Ppm -> write_uncompressed Ppm
  | Png -> write_png

let save format ~path band picture =
  Atomic_file.save ~path (write format band picture)

let output format channel band picture =
  Atomic_file.output channel (write format band picture)

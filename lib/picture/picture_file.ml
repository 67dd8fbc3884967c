type format = Bmp | Png | Ppm

let formats = [ (".bmp", Bmp); (".png", Png); (".ppm", Ppm) ]
let extension format = fst (List.find (fun (_, f) -> f = format) formats)

let format_of_path ?(default = Bmp) path =
  match Extension.of_path path with
  | Error message -> Error message
  | Ok "" -> Ok default
  | Ok extension -> (
      match List.assoc_opt extension formats with
      | Some format -> Ok format
      | None ->
          Error
            (Printf.sprintf
               "%s: there is no picture format '%s'; use .bmp, .png or .ppm"
               path extension))

let most_bytes = 1 lsl 32

(* The lengths in the header of a BMP have 32 bits; a row is filled up to a
   multiple of 4 bytes, and there are headers, and there may be a label. *)
let bmp_bytes ~width ~height =
  let row = Float.ceil (0.75 *. float_of_int width) *. 4. in
  (row *. float_of_int height) +. 512.

let check_format format ~width ~height =
  if format = Bmp && bmp_bytes ~width ~height > 0x1p32 then
    Error
      (Printf.sprintf
         "a BMP of %d x %d pixels is too large: no BMP has more than 4 GiB. \
          Use .png or .ppm"
         width height)
  else Ok ()

let check_size format ~width ~height =
  let bytes = 3. *. float_of_int width *. float_of_int height in
  if bytes > float_of_int most_bytes then
    Error
      (Printf.sprintf
         "a picture of %d x %d pixels would take %.1f GiB of memory; the \
          limit is %d GiB"
         width height (bytes /. 0x1p30) (most_bytes lsr 30))
  else check_format format ~width ~height

(* {1 Writing} *)

let write = function
  | Bmp -> Uncompressed.write Bmp
  | Ppm -> Uncompressed.write Ppm
  | Png -> Png_file.write

let save_pixels format ~path pixels =
  Atomic_file.save ~path (write format pixels)

let output_pixels format channel pixels =
  Atomic_file.output channel (write format pixels)

let check format ~path ~width ~height =
  let bytes = match format with Png -> 1 | Bmp | Ppm -> 3 * width * height in
  Atomic_file.check ~path ~bytes

let save format ~path picture =
  save_pixels format ~path (Pixels.of_picture picture)

let output format channel picture =
  output_pixels format channel (Pixels.of_picture picture)

open Raylab_tracer

type format = Bmp | Png | Ppm

let formats = [ (".bmp", Bmp); (".png", Png); (".ppm", Ppm) ]

let format_of_path path =
  match String.lowercase_ascii (Filename.extension path) with
  | "" -> Ok Bmp
  | extension -> (
      match List.assoc_opt extension formats with
      | Some format -> Ok format
      | None ->
          Error
            (Printf.sprintf
               "%s: there is no picture format '%s'; use .bmp, .png or .ppm"
               path extension))

let most_bytes = 1 lsl 32

(* The library that writes PNG crashes from about 26,000 pixels a side on. *)
let longest_png_side = 25_000

(* The lengths in the header of a BMP have 32 bits; a row is filled up to a
   multiple of 4 bytes, and there are 55 bytes before the first. *)
let bmp_bytes ~width ~height =
  let row = Float.ceil (0.75 *. float_of_int width) *. 4. in
  (row *. float_of_int height) +. 55.

let check_format format ~width ~height =
  if format = Png && Int.max width height > longest_png_side then
    Error
      (Printf.sprintf
         "a PNG of %d x %d pixels is too large; the limit is %d a side. Use \
          .bmp or .ppm"
         width height longest_png_side)
  else if format = Bmp && bmp_bytes ~width ~height > 0x1p32 -. 1. then
    Error
      (Printf.sprintf
         "a BMP of %d x %d pixels is too large: no BMP has more than 4 GiB. \
          Use .ppm"
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

(* libpng does not say why it cannot write. *)
let png_is_cut_off () = raise (Sys_error "no space left on the device?")

let write_file format path picture =
  let image =
    Images.Rgb24
      (Rgb24.create_with (Picture.width picture) (Picture.height picture) []
         (Picture.to_rgb picture))
  in
  match format with
  | Bmp -> Bmp.save path [] image
  | Png -> ( try Png.save path [] image with Failure _ -> png_is_cut_off ())
  | Ppm -> Ppm.save path [] image

(* The last chunk of every PNG file. *)
let png_end = "\x00\x00\x00\x00IEND\xae\x42\x60\x82"

(* libpng's caller does not look whether its last write succeeded. *)
let check_whole format path =
  let is_whole () =
    In_channel.with_open_bin path (fun channel ->
        let length = In_channel.length channel in
        let tail = Int64.of_int (String.length png_end) in
        length > tail
        &&
        (In_channel.seek channel (Int64.sub length tail);
         In_channel.input_all channel = png_end))
  in
  if format = Png && not (is_whole ()) then png_is_cut_off ()

let write format picture path =
  write_file format path picture;
  check_whole format path

let save format ~path picture = Atomic_file.save ~path (write format picture)

let output format channel picture =
  Atomic_file.output channel (write format picture)

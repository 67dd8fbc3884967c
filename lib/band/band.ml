open Raylab_geometry
open Raylab_scene
open Raylab_picture

type whole = {
  width : int;
  height : int;
  grey : bool;
  film : Film.t;
  scene : Digest.t;
  version : string;
}

type t = { whole : whole; first : int; last : int }

let is_version text =
  let is_allowed = function
    | '0' .. '9' | 'a' .. 'z' | 'A' .. 'Z' | '.' | '-' | '+' | '~' -> true
    | _ -> false
  in
  let n = String.length text in
  1 <= n && n <= 32 && String.for_all is_allowed text

let is_valid { whole = { width; height; version; _ }; first; last } =
  let is_size n = 1 <= n && n <= Camera.max_size in
  is_size width && is_size height && is_version version && 0 <= first
  && first <= last && last < height

let make whole ~first ~last =
  let band = { whole; first; last } in
  if not (is_valid band) then invalid_arg "Band.make";
  band

let rows { first; last; _ } = last - first + 1

let difference a b =
  if (a.width, a.height) <> (b.width, b.height) then
    Some
      (Printf.sprintf "the sizes differ, %dx%d and %dx%d" a.width a.height
         b.width b.height)
  else if a.scene <> b.scene then Some "the scenes differ"
  else if a.grey <> b.grey then Some "one is grey"
  else if a.film.samples <> b.film.samples then
    Some
      (Printf.sprintf "the samples differ, %d and %d" a.film.samples
         b.film.samples)
  else if a.film.exposure <> b.film.exposure then
    Some
      (Printf.sprintf "the exposures differ, %s and %s"
         (Number.to_exact_string a.film.exposure)
         (Number.to_exact_string b.film.exposure))
  else if a.film.srgb <> b.film.srgb then Some "one is srgb"
  else if a.version <> b.version then
    Some
      (Printf.sprintf "the versions of raylab differ, %s and %s" a.version
         b.version)
  else None

(* {1 Labels} *)

let color grey = if grey then "grey" else "rgb"
let encoding srgb = if srgb then "srgb" else "linear"

let without_checksum { whole; first; last } =
  let { Film.samples; exposure; srgb } = whole.film in
  Printf.sprintf
    "raylab-band 2 rows %d-%d of %dx%d %s samples %d exposure %s %s scene %s \
     raylab %s"
    first last whole.width whole.height (color whole.grey) samples
    (Number.to_exact_string exposure)
    (encoding srgb)
    (Digest.to_hex whole.scene)
    whole.version

let checksum band = Crc32.add Crc32.empty (without_checksum band)
let with_checksum band = Printf.sprintf "%s crc32 %s" (without_checksum band)
let label band crc = with_checksum band (Crc32.to_hex crc)

let scan text =
  let band first last width height color samples exposure encoding scene
      version crc =
    let grey = color = "grey" and scene = Digest.from_hex scene in
    let film = Film.make ~samples ~exposure ~srgb:(encoding = "srgb") () in
    let whole = { width; height; grey; film; scene; version } in
    ({ whole; first; last }, crc)
  in
  Scanf.sscanf text
    "raylab-band 2 rows %d-%d of %dx%d %s samples %d exposure %f %s scene \
     %32[0-9a-f] raylab %s crc32 %8[0-9a-f]%!"
    band

let of_label text =
  match scan text with
  (* Scanf takes more than [label] makes, such as blanks and zeros *)
  | band, crc
    when is_valid band
         && String.length crc = 8
         && with_checksum band crc = text ->
      Some (band, crc)
  | _ -> None
  | exception (Scanf.Scan_failure _ | Failure _ | End_of_file) -> None
  | exception Invalid_argument _ -> None

open Raylab_picture

type form = Uncompressed of Uncompressed.t | Png
type t = { path : string; band : Band.t; form : form; start : int }

exception Unreadable of string

let path file = file.path
let band file = file.band

(* The system's messages start with the path, or do not name it. *)
let message path reason =
  let prefix = path ^ ": " in
  if String.starts_with ~prefix reason then reason else prefix ^ reason

let unreadable path reason = raise (Unreadable (message path reason))

(* [reading path f] is [f ()], which only reads. *)
let reading path f =
  match f () with
  | result -> result
  | exception Sys_error reason -> unreadable path reason
  | exception End_of_file -> unreadable path "the file ends too early"

let uncompressed_rows file format channel ~first ~count =
  let { Band.whole = { width; _ }; first = top; last } = file.band in
  let stride = Uncompressed.stride format ~width in
  let before =
    if Uncompressed.lowest_first format then last - (first + count - 1)
    else first - top
  in
  let at = file.start + (before * stride) in
  let bytes = Bytes.create (count * stride) in
  reading file.path (fun () ->
      In_channel.seek channel (Int64.of_int at);
      really_input channel bytes 0 (count * stride));
  Uncompressed.decode format ~width bytes

let load_png { path; band; _ } channel =
  let read () =
    Png_file.read channel ~width:band.whole.width ~height:(Band.rows band)
  in
  match reading path read with
  | Some rgb -> rgb
  | None ->
      unreadable path
        "the band is damaged: not all of its parts are there and right"

let rows file channel =
  match file.form with
  | Uncompressed format -> uncompressed_rows file format channel
  | Png ->
      let { Band.whole = { width; _ }; first; _ } = file.band in
      Rows.of_bytes ~width ~top:first (load_png file channel)

let with_rows file f =
  let channel = reading file.path (fun () -> open_in_bin file.path) in
  Fun.protect
    ~finally:(fun () -> close_in_noerr channel)
    (fun () -> f (rows file channel))

(* {1 Checking} *)

let no_band =
  "not a band, or its label is damaged: raylab render --rows writes bands"

let damaged what = Error ("the band is damaged: " ^ what)

(* Labels, and what lies before them, are smaller. *)
let most_around_label = 512

(* [part channel] is what follows, but not more than that. *)
let part channel =
  let part = Bytes.create most_around_label in
  let rec fill n =
    match In_channel.input channel part n (most_around_label - n) with
    | 0 -> Bytes.sub_string part 0 n
    | count -> fill (n + count)
  in
  fill 0

(* [ends channel] is what its file starts with and what it ends with. *)
let ends channel =
  let start = part channel in
  let last =
    Int64.(sub (In_channel.length channel) (of_int most_around_label))
  in
  In_channel.seek channel (Int64.max 0L last);
  (start, part channel)

let forms =
  [
    (Uncompressed Uncompressed.Bmp, Uncompressed.label Bmp);
    (Uncompressed Ppm, Uncompressed.label Ppm);
    (Png, fun ~start ~stop:_ -> Png_file.label start);
  ]

let find_label ~start ~stop =
  List.find_map
    (fun (form, find) ->
      Option.bind (find ~start ~stop) Band.of_label
      |> Option.map (fun (band, crc) -> (form, band, crc)))
    forms

let ( let* ) = Result.bind

(* [check_frame] is about everything but the pixels, and where they start. *)
let check_frame channel form start band crc =
  let width = band.Band.whole.width and height = Band.rows band in
  let* () = Picture_file.check_size Ppm ~width ~height in
  match form with
  | Png -> Ok 0
  | Uncompressed format ->
      let label = Some (Band.with_checksum band crc) in
      let header = Uncompressed.header format ~label ~width ~height in
      let before = String.length header
      and pixels = Uncompressed.stride format ~width * height
      and after = String.length (Uncompressed.trailer format ~label) in
      let length = Int64.to_int (In_channel.length channel)
      and whole = before + pixels + after in
      if not (String.starts_with ~prefix:header start) then
        damaged "its header is not what its label says"
      else if length <> whole then
        damaged (Printf.sprintf "it has %d bytes instead of %d" length whole)
      else Ok before

let checksum file =
  let { Band.whole = { width; _ }; first; last } = file.band in
  with_rows file (fun rows ->
      Seq.fold_left
        (fun crc (first, count) -> Crc32.add_bytes crc (rows ~first ~count))
        (Band.checksum file.band)
        (Rows.pieces ~width ~first ~last))

let check_exn path =
  let* file, crc =
    reading path (fun () ->
        In_channel.with_open_bin path (fun channel ->
            let start, stop = ends channel in
            match find_label ~start ~stop with
            | None -> Error no_band
            | Some (form, band, crc) ->
                let* start = check_frame channel form start band crc in
                Ok ({ path; band; form; start }, crc)))
  in
  if Crc32.to_hex (checksum file) = crc then Ok file
  else damaged "its pixels do not have the checksum of its label"

let check path =
  match check_exn path with
  | Ok file -> Ok file
  | Error reason -> Error (message path reason)
  | exception Unreadable message -> Error message

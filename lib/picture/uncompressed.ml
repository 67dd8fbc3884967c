type t = Bmp | Ppm

let lowest_first = function Bmp -> true | Ppm -> false

let stride format ~width =
  match format with Ppm -> 3 * width | Bmp -> ((3 * width) + 3) / 4 * 4

(* {1 Before and after the rows} *)

let magic = function Ppm -> "P6\n" | Bmp -> "BM"

let ppm_header ~label ~width ~height =
  let comment = Option.fold ~none:"" ~some:(Printf.sprintf "# %s\n") label in
  Printf.sprintf "%s%s%d %d\n255\n" (magic Ppm) comment width height

let trailer format ~label =
  match (format, label) with
  | Bmp, Some label -> "\n" ^ label ^ "\n"
  | Bmp, None | Ppm, _ -> ""

(* A file header of 14 bytes and an information header of 40. *)
let bmp_fixed = 54

(* 72 an inch, as most programs say that do not know better. *)
let pixels_a_metre = 2835

let bmp_header ~label ~width ~height =
  let pixels = stride Bmp ~width * height in
  let length = bmp_fixed + pixels + String.length (trailer Bmp ~label) in
  let header = Buffer.create bmp_fixed in
  let int32 n = Buffer.add_int32_le header (Int32.of_int n) in
  Buffer.add_string header (magic Bmp);
  List.iter int32 [ length; 0; bmp_fixed; 40; width; height ];
  (* planes, and bits a pixel *)
  List.iter (Buffer.add_int16_le header) [ 1; 24 ];
  (* no compression, and no palette at the end *)
  List.iter int32 [ 0; pixels; pixels_a_metre; pixels_a_metre; 0; 0 ];
  Buffer.contents header

let header format ~label =
  match format with Bmp -> bmp_header ~label | Ppm -> ppm_header ~label

let second_line text =
  match String.split_on_char '\n' text with
  | _ :: comment :: _ :: _ when String.starts_with ~prefix:"# " comment ->
      Some (String.sub comment 2 (String.length comment - 2))
  | _ -> None

let last_line text =
  match List.rev (String.split_on_char '\n' text) with
  | "" :: line :: _ :: _ -> Some line
  | _ -> None

let label format ~start ~stop =
  if not (String.starts_with ~prefix:(magic format) start) then None
  else match format with Ppm -> second_line start | Bmp -> last_line stop

(* {1 Rows} *)

(* [swap_row ~width source from target into] has blue for red. *)
let swap_row ~width source from target into =
  for x = 0 to width - 1 do
    let from = from + (3 * x) and into = into + (3 * x) in
    Bytes.set target into (Bytes.get source (from + 2));
    Bytes.set target (into + 1) (Bytes.get source (from + 1));
    Bytes.set target (into + 2) (Bytes.get source from)
  done

let decode_bmp ~width bytes =
  let stride = stride Bmp ~width in
  let rows = Bytes.length bytes / stride in
  let rgb = Bytes.create (3 * width * rows) in
  for y = 0 to rows - 1 do
    swap_row ~width bytes (y * stride) rgb (3 * width * (rows - 1 - y))
  done;
  rgb

let decode format ~width bytes =
  match format with Ppm -> bytes | Bmp -> decode_bmp ~width bytes

(* A row at a time, so that no room is needed for more. *)
let output_bmp ~width channel =
  let row = Bytes.make (stride Bmp ~width) '\000' in
  fun rgb at length ->
    for y = (length / (3 * width)) - 1 downto 0 do
      swap_row ~width rgb (at + (3 * width * y)) row 0;
      output_bytes channel row
    done

let write format { Pixels.width; height; label; iter } channel =
  output_string channel (header format ~label ~width ~height);
  (match format with
  | Ppm -> iter ~lowest_first:false (output channel)
  | Bmp -> iter ~lowest_first:true (output_bmp ~width channel));
  output_string channel (trailer format ~label)

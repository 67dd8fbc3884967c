type t = Bmp | Ppm

let lowest_first = function Bmp -> true | Ppm -> false

let stride format ~width =
  match format with Ppm -> 3 * width | Bmp -> ((3 * width) + 3) / 4 * 4

(* {1 Headers} *)

let magic = function Ppm -> "P6\n" | Bmp -> "BM"

let ppm_header ~label ~width ~height =
  let comment = if label = "" then "" else "# " ^ label ^ "\n" in
  Printf.sprintf "%s%s# CREATOR: CamlImages package\n%d %d\n255\n" (magic Ppm)
    comment width height

(* A file header of 14 bytes and an information header of 40. *)
let bmp_fixed = 54

let bmp_header ~label ~width ~height =
  let start = bmp_fixed + String.length label + 1 in
  let pixels = stride Bmp ~width * height in
  let header = Buffer.create start in
  let int32 n = Buffer.add_int32_le header (Int32.of_int n) in
  Buffer.add_string header (magic Bmp);
  List.iter int32 [ start + pixels; 0; start; 40; width; height ];
  (* planes, and bits a pixel *)
  List.iter (Buffer.add_int16_le header) [ 1; 24 ];
  (* no compression; pixels a metre; colours of a palette *)
  List.iter int32 [ 0; pixels; 600; 600; 0; 0 ];
  Buffer.add_string header label;
  Buffer.add_char header '\000';
  Buffer.contents header

let header = function Bmp -> bmp_header | Ppm -> ppm_header

let label format start =
  let before, stop =
    match format with
    | Bmp -> (bmp_fixed, '\000')
    | Ppm -> (String.length (magic Ppm ^ "# "), '\n')
  in
  if
    String.starts_with ~prefix:(magic format) start
    && before < String.length start
  then
    let length_to at = String.sub start before (at - before) in
    Option.map length_to (String.index_from_opt start before stop)
  else None

(* {1 Rows} *)

let swap_row ~width source from target into =
  for x = 0 to width - 1 do
    let from = from + (3 * x) and into = into + (3 * x) in
    Bytes.set target into (Bytes.get source (from + 2));
    Bytes.set target (into + 1) (Bytes.get source (from + 1));
    Bytes.set target (into + 2) (Bytes.get source from)
  done

(* [swap ~width source a b] has the rows of [source], [a] bytes each, the other
   way round, blue for red, [b] bytes each. *)
let swap ~width source a b =
  let rows = Bytes.length source / a in
  let target = Bytes.make (rows * b) '\000' in
  for y = 0 to rows - 1 do
    swap_row ~width source (y * a) target ((rows - 1 - y) * b)
  done;
  target

let encode format ~width rgb =
  match format with
  | Ppm -> rgb
  | Bmp -> swap ~width rgb (3 * width) (stride Bmp ~width)

let decode format ~width bytes =
  match format with
  | Ppm -> bytes
  | Bmp -> swap ~width bytes (stride Bmp ~width) (3 * width)

(* {1 Files} *)

let write format ~label ~width ~height iter path =
  Out_channel.with_open_bin path (fun channel ->
      output_string channel (header format ~label ~width ~height);
      iter ~lowest_first:(lowest_first format) (fun rgb ->
          output_bytes channel (encode format ~width rgb));
      (* closing would not tell of a full disk *)
      flush channel)

let signature = "\x89PNG\r\n\x1a\n"

(* {1 Chunks}

   A chunk is the length of its data, its name, the data and a checksum. *)

let put channel name data =
  let text = name ^ data in
  output_binary_int channel (String.length data);
  output_string channel text;
  output_binary_int channel (Crc32.add Crc32.empty text :> int)

exception Damaged

(* Small ones, so that no reader needs much memory. *)
let most_data = 1 lsl 16

let next channel =
  let length = input_binary_int channel in
  if length < 0 || length > 2 * most_data then raise Damaged;
  let text = really_input_string channel (4 + length) in
  let crc = input_binary_int channel land 0xffffffff in
  if crc <> (Crc32.add Crc32.empty text :> int) then raise Damaged;
  (String.sub text 0 4, String.sub text 4 length)

(* {1 The first two} *)

let header ~width ~height =
  let header = Buffer.create 13 in
  List.iter
    (fun n -> Buffer.add_int32_be header (Int32.of_int n))
    [ width; height ];
  (* bits a channel; red, green, blue; deflate; its filters; not interlaced *)
  Buffer.add_string header "\x08\x02\x00\x00\x00";
  Buffer.contents header

let keyword = "Comment\000"
let text label = keyword ^ label

let label start =
  let before = "tEXt" ^ keyword in
  (* a chunk has 12 bytes besides its data *)
  let second = String.length signature + 12 + 13 in
  let at = second + 4 + String.length before in
  let has text at =
    at + String.length text <= String.length start
    && String.sub start at (String.length text) = text
  in
  if has signature 0 && has before (second + 4) then
    let length = Int32.to_int (String.get_int32_be start second) in
    let length = length - String.length keyword in
    if 0 <= length && length <= String.length start - at then
      Some (String.sub start at length)
    else None
  else None

let signature = "\x89PNG\r\n\x1a\n"

let int32 n =
  let bytes = Bytes.create 4 in
  Bytes.set_int32_be bytes 0 (Int32.of_int n);
  Bytes.to_string bytes

let get_int32 text at =
  Int32.to_int (String.get_int32_be text at) land 0xffffffff

(* A chunk is the length of its data, its name, the data and a checksum. *)
let around_data = 12

let chunk name data =
  let crc = Crc32.add Crc32.empty (name ^ data) in
  int32 (String.length data) ^ name ^ data ^ int32 (crc :> int)

let size_header ~width ~height =
  (* bits a channel, red green blue, deflate, its filters, interlaced *)
  let kind = "\x08\x02\x00\x00\x01" in
  signature ^ chunk "IHDR" (int32 width ^ int32 height ^ kind)

let second = String.length (size_header ~width:1 ~height:1)
let keyword = "Comment\000"

let insert label png =
  String.sub png 0 second
  ^ chunk "tEXt" (keyword ^ label)
  ^ String.sub png second (String.length png - second)

(* [name_and_data text at] is that of the chunk at [at], if it is all there. *)
let name_and_data text at =
  let left = String.length text - at - around_data in
  if left < 0 || get_int32 text at > left then None
  else Some (String.sub text (at + 4) (4 + get_int32 text at))

let find start =
  let before = "tEXt" ^ keyword in
  match
    if String.starts_with ~prefix:signature start then
      name_and_data start second
    else None
  with
  | Some chunk when String.starts_with ~prefix:before chunk ->
      let n = String.length before in
      Some (String.sub chunk n (String.length chunk - n))
  | _ -> None

let rec are_chunks png at =
  match name_and_data png at with
  | None -> false
  | Some chunk ->
      let next = at + 8 + String.length chunk in
      let crc = Crc32.add Crc32.empty chunk in
      get_int32 png (next - 4) = (crc :> int)
      &&
      if chunk = "IEND" then next = String.length png else are_chunks png next

let is_whole png ~width ~height =
  String.starts_with ~prefix:(size_header ~width ~height) png
  && are_chunks png second

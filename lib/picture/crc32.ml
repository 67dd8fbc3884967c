type t = int

let empty = 0
let of_int32 crc = Int32.to_int crc land 0xffffffff

let add crc text =
  of_int32
    (Zlib.update_crc_string (Int32.of_int crc) text 0 (String.length text))

(* the string does not leave [add] *)
let add_bytes crc bytes = add crc (Bytes.unsafe_to_string bytes)
let to_hex = Printf.sprintf "%08x"

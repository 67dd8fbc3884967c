type t = int

let empty = 0

let table =
  let divide n = if n land 1 = 1 then 0xedb88320 lxor (n lsr 1) else n lsr 1 in
  let rec repeat k n = if k = 0 then n else repeat (k - 1) (divide n) in
  Array.init 256 (repeat 8)

let add crc text =
  let update crc c = table.(crc lxor Char.code c land 0xff) lxor (crc lsr 8) in
  String.fold_left update (crc lxor 0xffffffff) text lxor 0xffffffff

(* the string does not leave [add] *)
let add_bytes crc bytes = add crc (Bytes.unsafe_to_string bytes)
let to_hex = Printf.sprintf "%08x"

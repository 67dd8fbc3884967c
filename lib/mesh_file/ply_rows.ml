type t =
  | Text of Words.t
  | Binary of { bytes : string; big : bool; mutable at : int }

let start (header : Ply_header.t) bytes =
  match header.format with
  | Ascii -> Text (Words.start bytes ~at:header.body ~line:header.body_line)
  | Little_endian -> Binary { bytes; big = false; at = header.body }
  | Big_endian -> Binary { bytes; big = true; at = header.body }

let place = function
  | Text words -> Words.place words
  | Binary { at; _ } -> Fault.Byte at

(* {1 Rows} *)

(* A text has at least a digit and a blank for each number. *)
let least_size rows (property : Ply_header.property) =
  match (rows, property) with
  | Text _, _ -> 2
  | Binary _, Scalar { item; _ } -> Ply_header.bytes item
  | Binary _, List { count; _ } -> Ply_header.bytes count

let left = function
  | Text words -> Words.left words + 1
  | Binary { bytes; at; _ } -> String.length bytes - at

let check rows (element : Ply_header.element) =
  let row =
    List.fold_left
      (fun sum property -> sum + least_size rows property)
      0 element.properties
  in
  if float_of_int row *. float_of_int element.count > float_of_int (left rows)
  then
    Fault.fail element.declared
      "%d rows of %d numbers or more are announced, and the file is too short \
       for them"
      element.count
      (List.length element.properties)

let ended rows =
  Fault.fail (place rows) "the file ends in the middle of its rows"

let start_row rows =
  match rows with
  | Binary _ -> ()
  | Text words ->
      let rec go () =
        if Words.next words && not (Words.is words "comment") then
          Words.back words
        else if Words.next_line words then go ()
        else ended rows
      in
      go ()

let end_row = function
  | Binary _ -> ()
  | Text words ->
      if Words.next words then
        Fault.fail (Words.place words)
          "%s is more than the row has properties for" (Words.text words);
      ignore (Words.next_line words : bool)

(* {1 Numbers} *)

let binary rows bytes big at (scalar : Ply_header.scalar) =
  if at + Ply_header.bytes scalar > String.length bytes then ended rows;
  let int32 = if big then String.get_int32_be else String.get_int32_le
  and int64 = if big then String.get_int64_be else String.get_int64_le
  and int16 = if big then String.get_int16_be else String.get_int16_le
  and uint16 = if big then String.get_uint16_be else String.get_uint16_le in
  match scalar with
  | Int8 -> float_of_int (String.get_int8 bytes at)
  | Uint8 -> float_of_int (String.get_uint8 bytes at)
  | Int16 -> float_of_int (int16 bytes at)
  | Uint16 -> float_of_int (uint16 bytes at)
  | Int32 -> Int32.to_float (int32 bytes at)
  | Uint32 ->
      let low, high = if big then (at + 2, at) else (at, at + 2) in
      float_of_int (uint16 bytes low)
      +. (65536. *. float_of_int (uint16 bytes high))
  | Float32 -> Int32.float_of_bits (int32 bytes at)
  | Float64 -> Int64.float_of_bits (int64 bytes at)

let next rows scalar =
  match rows with
  | Text words -> Words.next_number words "a number of the row"
  | Binary b ->
      let x = binary rows b.bytes b.big b.at scalar in
      b.at <- b.at + Ply_header.bytes scalar;
      x

let next_int rows scalar =
  let x = next rows scalar in
  if Float.is_integer x && abs_float x < 1e9 then int_of_float x
  else
    Fault.fail (place rows) "%.17g is no whole number of up to nine digits" x

(* The chunks are written here and zlib packs the pixels, since camlimages can
   have libpng write interlaced files only, of pictures that are in memory as a
   whole and have less than 26,000 pixels a side. *)

(* {1 Filtering}

   Of a row the differences are packed, of each byte to that of the pixel before
   it: the filter Sub. On the pictures of the gallery it gives smaller files
   than choosing the best of all filters for each row by the usual rule does. *)

let sub = '\001'

let filter row rgb at =
  Bytes.set row 0 sub;
  Bytes.blit rgb at row 1 3;
  for k = 3 to Bytes.length row - 2 do
    let before = Bytes.get_uint8 rgb (at + k - 3) in
    Bytes.set_uint8 row (k + 1) (Bytes.get_uint8 rgb (at + k) - before)
  done

let unfilter row rgb at =
  if Bytes.get row 0 <> sub then raise Png_chunk.Damaged;
  Bytes.blit row 1 rgb at 3;
  for k = 3 to Bytes.length row - 2 do
    let before = Bytes.get_uint8 rgb (at + k - 3) in
    Bytes.set_uint8 rgb (at + k) (Bytes.get_uint8 row (k + 1) + before)
  done

(* {1 Writing} *)

(* [packing channel] is what packs bytes into chunks, and what ends them. *)
let packing channel =
  let data = Buffer.create (2 * Png_chunk.most_data) in
  let put_data () =
    Png_chunk.put channel "IDAT" (Buffer.contents data);
    Buffer.clear data
  in
  let add packed count =
    Buffer.add_subbytes data packed 0 count;
    if Buffer.length data >= Png_chunk.most_data then put_data ()
  in
  let pack, finish = Zlib.compress_direct add in
  let finish () =
    finish ();
    if Buffer.length data > 0 then put_data ()
  in
  (pack, finish)

(* What is packed at once always is one row, and part of it if it is long, so
   that the pieces in which rows come make no difference to the file. *)
let most_packed = 1 lsl 20

let pack_row pack row =
  let rec from at =
    let count = Int.min most_packed (Bytes.length row - at) in
    if count > 0 then (
      pack row at count;
      from (at + count))
  in
  from 0

let label = Png_chunk.label

let write { Pixels.width; height; label; iter } channel =
  output_string channel Png_chunk.signature;
  Png_chunk.put channel "IHDR" (Png_chunk.header ~width ~height);
  Option.iter
    (fun label -> Png_chunk.put channel "tEXt" (Png_chunk.text label))
    label;
  let pack, finish = packing channel in
  let row = Bytes.create ((3 * width) + 1) in
  iter ~lowest_first:false (fun rgb at length ->
      for y = 0 to (length / (3 * width)) - 1 do
        filter row rgb (at + (3 * width * y));
        pack_row pack row
      done);
  finish ();
  Png_chunk.put channel "IEND" ""

(* {1 Reading} *)

(* [packed channel] is, call by call, the data of the chunks from here on, put
   into a buffer. *)
let packed channel =
  let data = ref "" and at = ref 0 in
  let rec fill buffer =
    let count = Int.min (Bytes.length buffer) (String.length !data - !at) in
    if count > 0 then (
      Bytes.blit_string !data !at buffer 0 count;
      at := !at + count;
      count)
    else
      match Png_chunk.next channel with
      | "IDAT", more ->
          data := more;
          at := 0;
          fill buffer
      | "tEXt", _ -> fill buffer
      | _ -> raise Png_chunk.Damaged
  in
  fill

(* [unpacking ~width ~height] is what takes bytes of filtered rows, and what
   gives the pixels when all are there. *)
let unpacking ~width ~height =
  let rgb = Bytes.create (3 * width * height) in
  let row = Bytes.create ((3 * width) + 1) in
  let filled = ref 0 and y = ref 0 in
  let rec take part at left =
    if left > 0 then (
      if !y = height then raise Png_chunk.Damaged;
      let count = Int.min left (Bytes.length row - !filled) in
      Bytes.blit part at row !filled count;
      filled := !filled + count;
      if !filled = Bytes.length row then (
        unfilter row rgb (3 * width * !y);
        incr y;
        filled := 0);
      take part (at + count) (left - count))
  in
  let pixels () = if !y = height then rgb else raise Png_chunk.Damaged in
  ((fun part count -> take part 0 count), pixels)

(* Deflate packs 1,032 bytes into one at most. Asked before room is made. *)
let most_times = 1100

let read_exn channel ~width ~height =
  let expect found = if not found then raise Png_chunk.Damaged in
  let start = String.length Png_chunk.signature in
  expect (really_input_string channel start = Png_chunk.signature);
  expect (Png_chunk.next channel = ("IHDR", Png_chunk.header ~width ~height));
  expect (3 * width * height / most_times < in_channel_length channel);
  let take, pixels = unpacking ~width ~height in
  Zlib.uncompress (packed channel) take;
  expect (Png_chunk.next channel = ("IEND", ""));
  expect (In_channel.input_char channel = None);
  pixels ()

let read channel ~width ~height =
  match read_exn channel ~width ~height with
  | rgb -> Some rgb
  | exception (Png_chunk.Damaged | End_of_file | Zlib.Error _) -> None

(* {1 Points in the same place are one} *)

type shared = {
  mesh : Builder.t;
  known : (float * float * float, int) Hashtbl.t;
}

let create ~most =
  { mesh = Builder.create ~most ~counted_from:1; known = Hashtbl.create 1024 }

let corner { mesh; known } place x y z =
  (* without the sign of a zero *)
  let point = (x +. 0., y +. 0., z +. 0.) in
  let point =
    match Hashtbl.find_opt known point with
    | Some point -> point
    | None ->
        let number = Builder.points mesh in
        Builder.point mesh place x y z;
        Hashtbl.add known point number;
        number
  in
  Builder.corner mesh ~point ~normal:(-1)

(* {1 Binary}

   80 bytes of any text, the count of triangles, and 50 bytes for each: its
   normal, three points, and two bytes that some programs use for colours. *)

let header = 84
let record = 50

(* Exact in a double, where integers may have 32 bits. *)
let count_of bytes =
  float_of_int (String.get_uint16_le bytes 80)
  +. (65536. *. float_of_int (String.get_uint16_le bytes 82))

let length_of bytes =
  float_of_int header +. (float_of_int record *. count_of bytes)

let is_binary bytes =
  String.length bytes >= header
  && length_of bytes = float_of_int (String.length bytes)

let single bytes at = Int32.float_of_bits (String.get_int32_le bytes at)

let read_binary ~most bytes =
  let shared = create ~most in
  for k = 0 to ((String.length bytes - header) / record) - 1 do
    let at = header + (k * record) in
    let place = Fault.Byte at in
    for corner_number = 1 to 3 do
      let at = at + (12 * corner_number) in
      corner shared (Byte at) (single bytes at)
        (single bytes (at + 4))
        (single bytes (at + 8))
    done;
    Builder.end_face shared.mesh place;
    if String.get_uint16_le bytes (at + 48) <> 0 then
      Builder.unused shared.mesh (Byte (at + 48)) "colours of triangles"
  done;
  shared.mesh

(* {1 Text} *)

let expect words word =
  if not (Words.next_anywhere words) then
    Fault.fail (Words.place words) "the file ends where %s should be" word;
  if not (Words.is words word) then
    Fault.fail (Words.place words) "%s stands where %s should be"
      (Words.text words) word

(* Three numbers, which may go on in the next line. *)
let triple words =
  let number what =
    if not (Words.next_anywhere words) then
      Fault.fail (Words.place words) "%s is missing" what;
    Words.number words
  in
  let x = number "the x" in
  let y = number "the y" in
  let z = number "the z" in
  (x, y, z)

let facet shared words =
  let place = Words.place words in
  expect words "normal";
  for _ = 1 to 3 do
    (* whatever it is: some programs write no numbers *)
    ignore (Words.next_anywhere words : bool)
  done;
  expect words "outer";
  expect words "loop";
  for _ = 1 to 3 do
    expect words "vertex";
    let x, y, z = triple words in
    corner shared (Words.place words) x y z
  done;
  expect words "endloop";
  expect words "endfacet";
  Builder.end_face shared.mesh place

(* A name may hold anything, to the end of its line. *)
let rec solids shared words =
  if Words.next_anywhere words then
    if Words.is words "facet" then (
      facet shared words;
      solids shared words)
    else if Words.is words "solid" || Words.is words "endsolid" then (
      if Words.next_line words then solids shared words)
    else
      Fault.fail (Words.place words) "%s stands where facet should be"
        (Words.text words)

let read_text ~most bytes =
  let shared = create ~most in
  solids shared (Words.start bytes);
  shared.mesh

(* {1 Which of them} *)

let begins_with_solid bytes =
  let words = Words.start bytes in
  Words.next_anywhere words && Words.is words "solid"

let read ~most bytes =
  if is_binary bytes then read_binary ~most bytes
  else if begins_with_solid bytes then read_text ~most bytes
  else if String.length bytes < header then
    Fault.fail Whole
      "the file is no STL: it neither begins with 'solid' nor has the %d \
       bytes of a binary one's header"
      header
  else
    Fault.fail (Byte 80)
      "%.0f triangles would need a file of %.0f bytes, and this one has %d"
      (count_of bytes) (length_of bytes) (String.length bytes)

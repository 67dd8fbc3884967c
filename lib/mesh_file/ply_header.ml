type scalar =
  | Int8
  | Uint8
  | Int16
  | Uint16
  | Int32
  | Uint32
  | Float32
  | Float64

let bytes = function
  | Int8 | Uint8 -> 1
  | Int16 | Uint16 -> 2
  | Int32 | Uint32 | Float32 -> 4
  | Float64 -> 8

type property =
  | Scalar of { name : string; item : scalar }
  | List of { name : string; count : scalar; item : scalar }

type element = {
  name : string;
  count : int;
  properties : property list;
  declared : Fault.place;
}

type format = Ascii | Little_endian | Big_endian

type t = {
  format : format;
  elements : element list;
  body : int;
  body_line : int;
}

let scalars =
  [
    (Int8, [ "char"; "int8" ]);
    (Uint8, [ "uchar"; "uint8" ]);
    (Int16, [ "short"; "int16" ]);
    (Uint16, [ "ushort"; "uint16" ]);
    (Int32, [ "int"; "int32" ]);
    (Uint32, [ "uint"; "uint32" ]);
    (Float32, [ "float"; "float32" ]);
    (Float64, [ "double"; "float64" ]);
  ]

let formats =
  [
    ("ascii", Ascii);
    ("binary_little_endian", Little_endian);
    ("binary_big_endian", Big_endian);
  ]

let need words what =
  if not (Words.next words) then
    Fault.fail (Words.place words) "%s is missing" what

let format words =
  need words "the format";
  match List.find_opt (fun (name, _) -> Words.is words name) formats with
  | Some (_, format) -> format
  | None ->
      Fault.fail (Words.place words)
        "%s is no format: there are ascii, binary_little_endian and \
         binary_big_endian"
        (Words.text words)

let scalar words what =
  need words what;
  let is (_, names) = List.exists (Words.is words) names in
  match List.find_opt is scalars with
  | Some (scalar, _) -> scalar
  | None ->
      Fault.fail (Words.place words) "%s is no type of a number: there are %s"
        (Words.text words)
        (String.concat ", " (List.concat_map snd scalars))

let name words =
  need words "the name";
  Words.raw words

let whole words scalar =
  match scalar with
  | Float32 | Float64 ->
      Fault.fail (Words.place words) "the length of a list is a whole number"
  | _ -> scalar

let property words =
  need words "the type";
  if Words.is words "list" then
    let count = whole words (scalar words "the type of the list's length") in
    let item = scalar words "the type of the list's items" in
    List { name = name words; count; item }
  else (
    Words.back words;
    let item = scalar words "the type" in
    Scalar { name = name words; item })

let element words =
  let name = name words in
  need words "the count";
  let count = Words.integer words in
  if count < 0 then Fault.fail (Words.place words) "a count cannot be negative";
  { name; count; properties = []; declared = Words.place words }

let add_property words elements =
  match elements with
  | [] ->
      Fault.fail (Words.place words)
        "a property stands before the first element"
  | element :: others ->
      let properties = property words :: element.properties in
      { element with properties } :: others

let in_order elements =
  let restore element =
    { element with properties = List.rev element.properties }
  in
  List.rev_map restore elements

let read bytes =
  let words = Words.start bytes in
  if not (Words.next words && Words.is words "ply") then
    Fault.fail (Words.place words) "a PLY file begins with 'ply'";
  let rec lines known elements =
    if not (Words.next_line words) then
      Fault.fail (Words.place words) "the header has no 'end_header'";
    if not (Words.next words) then lines known elements
    else if Words.is words "end_header" then (known, in_order elements)
    else if Words.is words "format" then lines (Some (format words)) elements
    else if Words.is words "comment" || Words.is words "obj_info" then
      lines known elements
    else if Words.is words "element" then
      lines known (element words :: elements)
    else if Words.is words "property" then
      lines known (add_property words elements)
    else
      Fault.fail (Words.place words) "%s is no line of a header"
        (Words.text words)
  in
  let known, elements = lines None [] in
  match known with
  | None -> Fault.fail (Words.place words) "the header tells no format"
  | Some format ->
      ignore (Words.next_line words : bool);
      {
        format;
        elements;
        body = Words.position words;
        body_line = Words.line words;
      }

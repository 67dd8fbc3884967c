let a = (0., 0., 0.)
and b = (1., 0., 0.)
and c = (1., 1., 0.)
and d = (0., 1., 0.)

let square = [ [ a; b; c ]; [ a; c; d ] ]
let lines = String.concat "\n"

let test_text () =
  Read.check_triangles "a square" square
    (Read.mesh Ply
       (lines
          [
            "ply";
            "format ascii 1.0";
            "comment element vertex 9";
            "obj_info anything";
            "element vertex 4";
            "property float x";
            "property float y";
            "property uchar red";
            "property float z";
            "element face 1";
            "property list uchar int vertex_indices";
            "end_header";
            "0 0 255 0";
            "1 0 255 0";
            "comment in between";
            "";
            "1 1 255 0";
            "0 1 255 0";
            "4 0 1 2 3";
            "";
          ]))

(* {1 Binary} *)

let header format =
  lines
    [
      "ply";
      "format " ^ format ^ " 1.0";
      "element other 2";
      "property list uchar short things";
      "element face 2";
      "property uchar flags";
      "property list ushort uint vertex_index";
      "element vertex 4";
      "property double z";
      "property float y";
      "property int8 x";
      "end_header";
      "";
    ]

let body ~big =
  let b = Buffer.create 100 in
  let int16 = if big then Buffer.add_int16_be b else Buffer.add_int16_le b
  and int32 = if big then Buffer.add_int32_be b else Buffer.add_int32_le b
  and int64 = if big then Buffer.add_int64_be b else Buffer.add_int64_le b in
  Buffer.add_uint8 b 0;
  Buffer.add_uint8 b 2;
  int16 7;
  int16 (-7);
  let face corners =
    Buffer.add_uint8 b 1;
    int16 3;
    List.iter int32 corners
  and point (x, y, z) =
    int64 (Int64.bits_of_float z);
    int32 (Int32.bits_of_float y);
    Buffer.add_int8 b (int_of_float x)
  in
  face [ 0l; 1l; 2l ];
  face [ 0l; 2l; 3l ];
  List.iter point [ a; (1., 0., 0.); c; d ];
  Buffer.contents b

let test_binary () =
  Read.check_triangles "the little end first" square
    (Read.mesh Ply (header "binary_little_endian" ^ body ~big:false));
  Read.check_triangles "the big end first" square
    (Read.mesh Ply (header "binary_big_endian" ^ body ~big:true));
  Alcotest.(check (list string))
    "other elements"
    [ "line 3: elements called 'other' are not used" ]
    (Read.warnings Ply (header "binary_big_endian" ^ body ~big:true))

(* The first face is after 5 bytes of the other element; the second has a byte,
   a length of two bytes, and three corners of four. *)
let test_places () =
  let header = header "binary_little_endian" in
  let mesh = Read.mesh Ply (header ^ body ~big:false) in
  let start = String.length header + 6 in
  Alcotest.(check (array int)) "bytes" [| start; start + 15 |] mesh.places

let small ?(format = "ascii") ?(count = "1") ?(list = "uchar int") rows =
  lines
    ([
       "ply";
       "format " ^ format ^ " 1.0";
       "element vertex 3";
       "property float x";
       "property float y";
       "property float z";
       "property float nx";
       "property float ny";
       "property float nz";
       "element face " ^ count;
       "property list " ^ list ^ " vertex_indices";
       "end_header";
     ]
    @ rows)

let points = [ "0 0 0 0 0 1"; "1 0 0 0 0 1"; "0 1 0 0 0 1" ]

let test_normals () =
  let mesh = Read.mesh Ply (small (points @ [ "3 0 1 2" ])) in
  Alcotest.(check (array int))
    "of the points" [| 0; 1; 2 |] mesh.corner_normals;
  Alcotest.(check (float 0.)) "z" 1. mesh.normals.(2)

let test_faults () =
  let check = Read.check_fault Ply in
  check "line 1: a PLY file begins with 'ply'" "solid";
  check "line 1: the header has no 'end_header'" "ply";
  check "line 2: the header tells no format" "ply\nend_header\n";
  check
    "line 2: 'xml' is no format: there are ascii, binary_little_endian and \
     binary_big_endian"
    (small ~format:"xml" points);
  check "line 11: the length of a list is a whole number"
    (small ~list:"float int" points);
  check "line 10: '12345678901' is too large" (small ~count:"12345678901" []);
  check
    "line 10: 99999 rows of 1 numbers or more are announced, and the file is \
     too short for them"
    (small ~count:"99999" (points @ [ "3 0 1 2" ]));
  check "line 16: a face has point 3, but there are only 3"
    (small (points @ [ "3 0 1 3" ]));
  check "line 16: a face has point -1, but there are only 3"
    (small (points @ [ "3 0 1 -1" ]));
  check "line 16: a number of the row is missing"
    (small (points @ [ "3 0 1" ]));
  check "line 16: '7' is more than the row has properties for"
    (small (points @ [ "3 0 1 2 7" ]));
  check "line 16: 1.5 is no whole number of up to nine digits"
    (small (points @ [ "3 0 1 1.5" ]));
  check "line 16: a face needs at least three corners, and this one has 2"
    (small (points @ [ "2 0 1" ]));
  let header = header "binary_little_endian" and body = body ~big:false in
  let cut = String.sub body 0 (String.length body - 1) in
  check
    "line 8: 4 rows of 3 numbers or more are announced, and the file is too \
     short for them"
    (header ^ cut)

let suite =
  ( "Ply",
    [
      Alcotest.test_case "text" `Quick test_text;
      Alcotest.test_case "binary" `Quick test_binary;
      Alcotest.test_case "places" `Quick test_places;
      Alcotest.test_case "normals" `Quick test_normals;
      Alcotest.test_case "faults" `Quick test_faults;
    ] )

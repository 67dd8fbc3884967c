let a = (0., 0., 0.)
and b = (1., 0., 0.)
and c = (0., 1., 0.)
and d = (1., 1., 0.)

let text =
  "solid a name, with anything: facet\n\
   facet normal nan nan nan\n\
  \ outer loop\n\
   vertex 0 0 0\n\
   VERTEX 1 0 0\n\
   vertex 0 1 0\n\
   endloop\n\
   endfacet\n\
   facet normal 0 0 1 outer loop\n\
   vertex -0 1 0 vertex 1 0 0\n\
   vertex 1 1 0\n\
   endloop endfacet\n\
   endsolid a name\n"

let two = [ [ a; b; c ]; [ c; b; d ] ]

let test_text () =
  Read.check_triangles "two triangles" two (Read.mesh Stl text);
  Alcotest.(check int)
    "points are shared" 12
    (Array.length (Read.mesh Stl text).points)

let binary ?(name = "solid, though binary") ?(colour = 0) triangles =
  let b = Buffer.create 200 in
  let single x = Buffer.add_int32_le b (Int32.bits_of_float x) in
  let triple (x, y, z) = List.iter single [ x; y; z ] in
  Buffer.add_string b (name ^ String.make (80 - String.length name) ' ');
  Buffer.add_int32_le b (Int32.of_int (List.length triangles));
  List.iter
    (fun corners ->
      triple (0., 0., 0.);
      List.iter triple corners;
      Buffer.add_uint16_le b colour)
    triangles;
  Buffer.contents b

let test_binary () =
  let mesh = Read.mesh Stl (binary two) in
  Read.check_triangles "two triangles" two mesh;
  Alcotest.(check (array int)) "bytes" [| 84; 134 |] mesh.places;
  Alcotest.(check (list string))
    "colours"
    [ "byte 132: colours of triangles are not used" ]
    (Read.warnings Stl (binary ~colour:31 two))

let replace a b text =
  let length = String.length a in
  let rec find i = if String.sub text i length = a then i else find (i + 1) in
  let i = find 0 in
  let after = i + length in
  String.sub text 0 i ^ b ^ String.sub text after (String.length text - after)

let test_faults () =
  let check = Read.check_fault Stl in
  check "line 4: 'vertx' stands where vertex should be"
    (replace "vertex" "vertx" text);
  check "line 5: 'x' is no number" (replace "VERTEX 1 0" "VERTEX 1 x" text);
  check "line 7: 'endfacet' stands where endloop should be"
    (replace "endloop\nendfacet" "endfacet" text);
  check "there is no face" "solid nothing\nendsolid";
  check "line 2: the file ends where normal should be" "solid\nfacet";
  check "line 2: 'facets' stands where facet should be" "solid\nfacets";
  let bytes = binary ~name:"made by hand" two in
  check
    "byte 80: 2 triangles would need a file of 184 bytes, and this one has 183"
    (String.sub bytes 0 183);
  check
    "the file is no STL: it neither begins with 'solid' nor has the 84 bytes \
     of a binary one's header"
    "hello";
  check "byte 96: the numbers of a point must be finite"
    (binary [ [ (nan, 0., 0.); b; c ] ])

let suite =
  ( "Stl",
    [
      Alcotest.test_case "text" `Quick test_text;
      Alcotest.test_case "binary" `Quick test_binary;
      Alcotest.test_case "faults" `Quick test_faults;
    ] )

let points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
let mesh text = Read.mesh Obj (points ^ text)

let a = (0., 0., 0.)
and b = (1., 0., 0.)
and c = (1., 1., 0.)
and d = (0., 1., 0.)

let test_faces () =
  let check what expected text =
    Read.check_triangles what expected (mesh text)
  in
  check "a triangle" [ [ a; b; c ] ] "f 1 2 3";
  check "from the last point" [ [ b; c; d ] ] "f -3 -2 -1";
  check "a square" [ [ a; b; c ]; [ a; c; d ] ] "f 1 2 3 4";
  check "with textures, and without a line end" [ [ a; b; d ] ] "f 1/7 2/8 4/9";
  check "that goes on in the next line" [ [ a; b; c ] ] "f 1 2 \\\n 3\n";
  check "after a comment" [ [ a; b; c ] ] "# f 2 3 4\nF 1 2 3 # 4";
  Read.check_triangles "points after the face"
    [ [ a; b; c ] ]
    (Read.mesh Obj "f 1 2 3\nv 0 0 0 1\nv 1 0 0\nv 1 1 0\n")

let test_places () =
  let mesh = mesh "\nf 1 2 3\n\ng wall\nf 1 2 3 4\n" in
  Alcotest.(check (array int)) "faces" [| 1; 2; 2 |] mesh.faces;
  Alcotest.(check (array int)) "lines" [| 6; 9; 9 |] mesh.places

let test_normals () =
  let text = "vn 0 0 2\nvn 0 0 0\nf 1//1 2//-1 3/5/1\nf 1 2 3\n" in
  let mesh = mesh text in
  Alcotest.(check (array int))
    "one of length 0 is none" [| 0; -1; 0; -1; -1; -1 |] mesh.corner_normals;
  Alcotest.(check (array int))
    "none at all" [||] (Read.mesh Obj (points ^ "f 1 2 3")).corner_normals

let test_warnings () =
  Alcotest.(check (list string))
    "what is not used"
    [
      "line 5: materials are not used";
      "line 6: colours of points are not used";
      "line 7: lines are not used";
      "line 8: lines that begin with 'hello' are not used";
      "line 10: faces have normals that are not in the file";
      "line 11: here is the first of 2 triangles that have two corners in one \
       place and are left out";
    ]
    (Read.warnings Obj
       (points
      ^ "mtllib a.mtl\n\
         v 1 1 1 0.5 0.5 0.5\n\
         l 1 2\n\
         hello\n\
         o it\n\
         f 1//1 2//2 3//3\n\
         f 1 1 2\n\
         f 1 2 2\n"))

let test_faults () =
  let check expected text = Read.check_fault Obj expected (points ^ text) in
  check "line 5: 'x' is no number" "v 0 x 0\nf 1 2 3";
  check "line 5: the z is missing" "v 0 0\nf 1 2 3";
  check "line 5: a face has point 5, but there are only 4" "f 1 2 5";
  check "line 5: '0' counts from 1, and from -1 backwards" "f 0 1 2";
  check "line 5: '-5' counts back beyond the first point" "f -5 1 2";
  check "line 5: '1.5' is no whole number" "f 1.5 2 3";
  check
    "line 5: '//2' is no corner: it is a point, point/texture, point//normal \
     or point/texture/normal"
    "f 1 2 //2";
  check "line 5: '12345678901' is too large" "f 1 2 12345678901";
  check "line 5: a face needs at least three corners, and this one has 2"
    "f 1 2";
  check "line 6: a face has normal 2, but there are only 1"
    "vn 0 0 1\nf 1//1 2//2 3//1";
  check "there is no face; lines are not used" "l 1 2 3";
  Read.check_fault Obj "there is no face" ""

let suite =
  ( "Obj",
    [
      Alcotest.test_case "faces" `Quick test_faces;
      Alcotest.test_case "places" `Quick test_places;
      Alcotest.test_case "normals" `Quick test_normals;
      Alcotest.test_case "warnings" `Quick test_warnings;
      Alcotest.test_case "faults" `Quick test_faults;
    ] )

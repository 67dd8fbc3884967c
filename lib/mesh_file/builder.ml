open Raylab_geometry
open Growing

type t = {
  most : int; (* triangles, and points *)
  counted_from : int;
  points : Floats.t;
  normals : Floats.t;
  corners : Ints.t; (* of all faces, one after another *)
  corner_normals : Ints.t;
  ends : Ints.t; (* where the corners of each face end *)
  places : Ints.t; (* of each face *)
  mutable triangles : int;
  mutable in_bytes : bool; (* whether places are bytes *)
  mutable has_normals : bool;
  mutable notes : (string * Fault.place) list; (* the last one first *)
}

let create ~most ~counted_from =
  {
    most;
    counted_from;
    points = Floats.create ();
    normals = Floats.create ();
    corners = Ints.create ();
    corner_normals = Ints.create ();
    ends = Ints.create ();
    places = Ints.create ();
    triangles = 0;
    in_bytes = false;
    has_normals = false;
    notes = [];
  }

let points mesh = Floats.length mesh.points / 3
let normals mesh = Floats.length mesh.normals / 3

let add_triple mesh numbers place what x y z =
  if not (Float.is_finite x && Float.is_finite y && Float.is_finite z) then
    Fault.fail place "the numbers of a %s must be finite" what;
  if Floats.length numbers / 3 >= mesh.most then
    Fault.fail place "there are more than %d %ss" mesh.most what;
  Floats.add numbers x;
  Floats.add numbers y;
  Floats.add numbers z

let point mesh place x y z = add_triple mesh mesh.points place "point" x y z
let normal mesh place x y z = add_triple mesh mesh.normals place "normal" x y z

(* {1 Faces} *)

let faces mesh = Ints.length mesh.ends
let end_of mesh face = if face < 0 then 0 else Ints.get mesh.ends face

let corner mesh ~point ~normal =
  Ints.add mesh.corners point;
  if normal >= 0 then mesh.has_normals <- true;
  Ints.add mesh.corner_normals normal

let end_face mesh (place : Fault.place) =
  let start = end_of mesh (faces mesh - 1)
  and stop = Ints.length mesh.corners in
  if stop - start < 3 then
    Fault.fail place "a face needs at least three corners, and this one has %d"
      (stop - start);
  mesh.triangles <- mesh.triangles + stop - start - 2;
  if mesh.triangles > mesh.most then
    Fault.fail place "the mesh has more than %d triangles" mesh.most;
  Ints.add mesh.ends stop;
  Ints.add mesh.places
    (match place with
    | Line n -> n
    | Byte n ->
        mesh.in_bytes <- true;
        n
    | Whole -> 0)

let place mesh face : Fault.place =
  let place = Ints.get mesh.places face in
  if mesh.in_bytes then Byte place else Line place

(* {1 The end} *)

let note mesh place message =
  if not (List.mem_assoc message mesh.notes) then
    mesh.notes <- (message, place) :: mesh.notes

let unused mesh place what = note mesh place (what ^ " are not used")

let check mesh place what index count =
  if index < 0 || index >= count then
    Fault.fail place "a face has %s %d, but there are only %d" what
      (index + mesh.counted_from)
      count

(* Some programs write faces with normals and leave out the normals. *)
let check_normal mesh place normal =
  if normal <> -1 then
    if normals mesh = 0 then
      note mesh place "faces have normals that are not in the file"
    else check mesh place "normal" normal (normals mesh)

let check_face mesh face start stop =
  let place = place mesh face in
  for k = start to stop - 1 do
    check mesh place "point" (Ints.get mesh.corners k) (points mesh);
    check_normal mesh place (Ints.get mesh.corner_normals k)
  done

type cut = {
  cut_corners : Ints.t;
  cut_normals : Ints.t;
  cut_faces : Ints.t;
  cut_places : Ints.t;
  mutable flat : int; (* triangles left out *)
  mutable first_flat : int; (* the face of the first of them *)
}

let coordinate mesh point axis = Floats.get mesh.points ((3 * point) + axis)

let at_one_place mesh a b =
  a = b
  || coordinate mesh a 0 = coordinate mesh b 0
     && coordinate mesh a 1 = coordinate mesh b 1
     && coordinate mesh a 2 = coordinate mesh b 2

let points_nowhere mesh normal =
  let is_zero axis = Floats.get mesh.normals ((3 * normal) + axis) = 0. in
  is_zero 0 && is_zero 1 && is_zero 2

let add_triangle mesh cut face start a b c =
  let point k = Ints.get mesh.corners (start + k) in
  let pa = point a and pb = point b and pc = point c in
  if
    at_one_place mesh pa pb || at_one_place mesh pb pc
    || at_one_place mesh pc pa
  then (
    if cut.flat = 0 then cut.first_flat <- face;
    cut.flat <- cut.flat + 1)
  else
    let with_normals = mesh.has_normals && normals mesh > 0 in
    let add k =
      Ints.add cut.cut_corners (point k);
      if with_normals then
        let normal = Ints.get mesh.corner_normals (start + k) in
        let none = normal = -1 || points_nowhere mesh normal in
        Ints.add cut.cut_normals (if none then -1 else normal)
    in
    add a;
    add b;
    add c;
    Ints.add cut.cut_faces (face + 1);
    Ints.add cut.cut_places (Ints.get mesh.places face)

let cut_face mesh cut face =
  let start = end_of mesh (face - 1) and stop = end_of mesh face in
  check_face mesh face start stop;
  let points k axis =
    coordinate mesh (Ints.get mesh.corners (start + k)) axis
  in
  let triangle = add_triangle mesh cut face start in
  if not (Polygon.cut ~points ~count:(stop - start) triangle) then
    Fault.fail (place mesh face)
      "a face has %d corners and is not convex; such faces may have %d"
      (stop - start) Polygon.max_concave

let warnings mesh cut : Fault.t list =
  let warning (message, place) : Fault.t = { place; message } in
  List.rev_map warning mesh.notes
  @
  if cut.flat = 0 then []
  else
    let message =
      if cut.flat = 1 then
        "a triangle has two corners in one place and is left out"
      else
        Printf.sprintf
          "here is the first of %d triangles that have two corners in one \
           place and are left out"
          cut.flat
    in
    [ { place = place mesh cut.first_flat; message } ]

let no_face mesh =
  let notes = List.rev_map fst mesh.notes in
  Fault.fail Whole "%s" (String.concat "; " ("there is no face" :: notes))

let finish mesh =
  if faces mesh = 0 then no_face mesh;
  let cut =
    {
      cut_corners = Ints.create ();
      cut_normals = Ints.create ();
      cut_faces = Ints.create ();
      cut_places = Ints.create ();
      flat = 0;
      first_flat = 0;
    }
  in
  for face = 0 to faces mesh - 1 do
    cut_face mesh cut face
  done;
  if Ints.length cut.cut_faces = 0 then
    Fault.fail (place mesh 0) "no face has three corners in different places";
  ( {
      Facets.points = Floats.to_array mesh.points;
      normals = Floats.to_array mesh.normals;
      corners = Ints.to_array cut.cut_corners;
      corner_normals = Ints.to_array cut.cut_normals;
      faces = Ints.to_array cut.cut_faces;
      places = Ints.to_array cut.cut_places;
      in_bytes = mesh.in_bytes;
    },
    warnings mesh cut )

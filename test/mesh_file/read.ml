open Raylab_geometry
open Raylab_mesh_file

let read format bytes =
  match Mesh_file.read format bytes with
  | Ok read -> read
  | Error fault -> Alcotest.fail (Fault.to_string fault)

let mesh format bytes = fst (read format bytes)
let warnings format bytes = List.map Fault.to_string (snd (read format bytes))

let fault format bytes =
  match Mesh_file.read format bytes with
  | Ok _ -> "none"
  | Error fault -> Fault.to_string fault

let triangles { Facets.points; corners; faces; _ } =
  let point k = (points.(3 * k), points.((3 * k) + 1), points.((3 * k) + 2)) in
  List.init (Array.length faces) (fun t ->
      List.init 3 (fun k -> point corners.((3 * t) + k)))

let check_triangles what expected facets =
  let exact = Alcotest.float 0. in
  Alcotest.(check (list (list (triple exact exact exact))))
    what expected (triangles facets)

let check_fault format expected bytes =
  Alcotest.(check string) expected expected (fault format bytes)

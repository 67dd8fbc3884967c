(* Whatever the bytes are, they are a mesh or a fault, and a mesh is whole. *)

open Raylab_geometry
open Raylab_mesh_file

let samples =
  [
    (Mesh_file.Obj, Test_obj.points ^ "vn 0 0 1\nf 1/1/1 2//1 3 -1\nf 1 2 3\n");
    (Ply, Test_ply.small (Test_ply.points @ [ "3 0 1 2" ]));
    (Ply, Test_ply.header "binary_big_endian" ^ Test_ply.body ~big:true);
    (Ply, Test_ply.header "binary_little_endian" ^ Test_ply.body ~big:false);
    (Stl, Test_stl.text);
    (Stl, Test_stl.binary Test_stl.two);
  ]

let pieces =
  [
    "0";
    "-1";
    "99999999999";
    "nan";
    "1e999";
    "1e308";
    "-1e-320";
    "\n";
    "\\\n";
    "\000";
    "\255\255";
  ]
  @ [ "f"; "element"; "vertex"; "list"; "/"; "#"; "endsolid"; "4294967295" ]

(* A sample with a piece of it left out and something put in its place. *)
let broken =
  QCheck2.Gen.(
    let* format, bytes = oneofl samples in
    let* changes = int_range 1 3 in
    let rec change bytes n =
      if n = 0 then return bytes
      else
        let* first = int_bound (String.length bytes) in
        let* length = frequency [ (5, int_bound 3); (1, int_bound 1000) ] in
        let stop = Int.min (first + length) (String.length bytes) in
        let* piece = oneof [ oneofl pieces; string_size (int_bound 4) ] in
        change
          (String.sub bytes 0 first ^ piece
          ^ String.sub bytes stop (String.length bytes - stop))
          (n - 1)
    in
    let* bytes = change bytes changes in
    return (format, bytes))

let is_whole (m : Facets.t) =
  let count = Facets.count m in
  let within array limit =
    Array.for_all (fun k -> 0 <= k && k < limit) array
  in
  count > 0
  && Array.length m.corners = 3 * count
  && Array.length m.places = count
  && (m.corner_normals = [||] || Array.length m.corner_normals = 3 * count)
  && within m.corners (Array.length m.points / 3)
  && Array.for_all
       (fun k -> -1 <= k && 3 * k < Array.length m.normals)
       m.corner_normals
  && Array.for_all Float.is_finite m.points
  && Array.for_all Float.is_finite m.normals

(* Whatever the numbers are. *)
let is_smooth facets =
  let model = Model.make ~name:"" facets in
  let { Facets.normals; corner_normals; _ } =
    Mesh.facets (Model.mesh model ~is_smooth:true)
  in
  let is_unit k =
    let at axis = normals.((3 * k) + axis) in
    let length = Vec3.length (Vec3.make (at 0) (at 1) (at 2)) in
    abs_float (length -. 1.) < 1e-12
  in
  Array.for_all is_unit corner_normals

let ends =
  Test_support.Property.holds "broken files are a mesh or a fault"
    ~count:20_000 broken (fun (format, bytes) ->
      match Mesh_file.read format bytes with
      | Ok (mesh, _) -> is_whole mesh && is_smooth mesh
      | Error { message; _ } -> message <> "")

let suite = ("broken files", [ ends ])

open Raylab_source

(* None has an edge or a corner before the eye of a camera that is not placed:
   of the triangles there either may be met.

   Corner k of the cube has the greater coordinate where k - 1 has a bit. *)
let cube =
  "v -0.9 -1.1 -0.8\nv 1.2 -1.1 -0.8\nv -0.9 1 -0.8\nv 1.2 1 -0.8\n\
   v -0.9 -1.1 1.3\nv 1.2 -1.1 1.3\nv -0.9 1 1.3\nv 1.2 1 1.3\n\
   f 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\nf 1 3 4 2\nf 5 6 8 7\n"
[@@ocamlformat "disable"]

let tetrahedron =
  "v -0.3 -0.2 0\nv 2.7 0.3 0\nv -0.3 1.8 0.25\nv 0.2 -0.2 4\n\
   f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
[@@ocamlformat "disable"]

let roof =
  "v -2 -0.7 -2\nv 2 -0.7 -2\nv 2 0.3 0.1\nv -2 0.3 0.1\nv 2 -0.7 2\nv -2 -0.7 2\n\
   vn 0 1 -1\nvn 0 1 0\nvn 0.5 1 0\nvn 0 1 1\n\
   f 1//1 2//1 3//2 4//3\nf 4//3 3//2 5//4 6//4\n"
[@@ocamlformat "disable"]

let all =
  [ ("cube.obj", cube); ("tetrahedron.obj", tetrahedron); ("roof.obj", roof) ]

let access =
  {
    Access.main = None;
    find = (fun ~from:_ name -> Ok { Access.path = name; identity = name });
    read =
      (fun ~limit:_ { Access.path; _ } ->
        match List.assoc_opt path all with
        | Some text -> Ok text
        | None -> Access.refuse "no other file can be read here");
  }

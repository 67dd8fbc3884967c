(* The meshes of the gallery and of the manual, one a name:

     dune exec scenes/meshes/make.exe knot > scenes/meshes/knot.obj *)

open Raylab_expression

let sin x = Degrees.sin (360. *. x)
let cos x = Degrees.cos (360. *. x)

(* {1 Vectors} *)

let ( ++ ) (x, y, z) (x', y', z') = (x +. x', y +. y', z +. z')
let ( *| ) k (x, y, z) = (k *. x, k *. y, k *. z)
let ( -- ) u v = u ++ (-1. *| v)

let cross (x, y, z) (x', y', z') =
  ((y *. z') -. (z *. y'), (z *. x') -. (x *. z'), (x *. y') -. (y *. x'))

let unit ((x, y, z) as v) = 1. /. sqrt ((x *. x) +. (y *. y) +. (z *. z)) *| v

(* {1 Files} *)

(* As short as it is exact enough. *)
let number x =
  let text = Printf.sprintf "%.4f" x in
  if text = "-0.0000" then "0.0000" else text

let vertex (x, y, z) =
  Printf.printf "v %s %s %s\n" (number x) (number y) (number z)

(* Corners are counted from 1. *)
let face corners =
  print_endline ("f " ^ String.concat " " (List.map string_of_int corners))

(* {1 A knot: it winds twice around a ring and three times through it} *)

let knot u =
  let around = 2. *. u and through = 3. *. u in
  let r = 1. +. (0.45 *. cos through) in
  (r *. cos around, 0.45 *. sin through, r *. sin around)

let tube line radius u v =
  let p = line u and along = unit (line (u +. 1e-4) -- line (u -. 1e-4)) in
  let aside = unit (cross along p) in
  p ++ (radius *| ((cos v *| aside) ++ (sin v *| cross along aside)))

(* Quads of a surface of two numbers from 0 to 1 that is closed both ways. *)
let closed surface ~us ~vs =
  let part k n = float_of_int k /. float_of_int n in
  let at i j = 1 + (i mod us * vs) + (j mod vs) in
  for i = 0 to us - 1 do
    for j = 0 to vs - 1 do
      vertex (surface (part i us) (part j vs))
    done
  done;
  for i = 0 to us - 1 do
    for j = 0 to vs - 1 do
      face [ at i j; at i (j + 1); at (i + 1) (j + 1); at (i + 1) j ]
    done
  done

(* {1 A fir, turned around the y axis: radius and height of each ring} *)

let fir =
  [ (0., 0.); (0.09, 0.); (0.08, 0.35); (0.62, 0.3); (0.3, 0.95); (0.5, 0.9) ]
  @ [ (0.22, 1.45); (0.36, 1.4); (0.15, 1.85); (0.23, 1.8); (0., 2.4) ]

(* The first and the last ring are points. *)
let turned rings ~sides =
  let last = List.length rings - 1 in
  let at ring side =
    if ring = 0 then 1
    else if ring = last then 2 + ((last - 1) * sides)
    else 2 + ((ring - 1) * sides) + (side mod sides)
  in
  List.iter
    (fun (radius, height) ->
      for side = 0 to if radius = 0. then 0 else sides - 1 do
        let u = float_of_int side /. float_of_int sides in
        vertex (radius *. cos u, height, radius *. sin u)
      done)
    rings;
  for ring = 0 to last - 1 do
    for side = 0 to sides - 1 do
      let a = at ring side and b = at (ring + 1) side in
      let c = at (ring + 1) (side + 1) and d = at ring (side + 1) in
      face
        (if a = d then [ a; b; c ]
         else if b = c then [ a; b; d ]
         else [ a; b; c; d ])
    done
  done

(* {1 Letters: their outlines, drawn out}

   A hole is joined to the outline by a cut, which is gone over twice. *)

let letters =
  let hole = [ (1, 7); (1, 6); (3, 6); (3, 4); (1, 4); (1, 6); (1, 7) ] in
  [
    ( 0.,
      [ (0, 0); (1, 0); (1, 3); (2, 3); (3, 0); (4, 0); (3, 3); (4, 4) ]
      @ [ (4, 6); (3, 7) ]
      @ hole
      @ [ (0, 7) ] );
    ( 5.,
      [ (0, 0); (1, 0); (1, 3); (3, 3); (3, 0); (4, 0); (4, 6); (3, 7) ]
      @ hole
      @ [ (0, 6) ] );
    ( 10.,
      [ (1, 0); (3, 0); (3, 3); (4, 5); (4, 7); (3, 7); (3, 5); (2, 4) ]
      @ [ (1, 5); (1, 7); (0, 7); (0, 5); (1, 3) ] );
  ]

(* Each edge of an outline, but for those of cuts. *)
let rec edges first = function
  | a :: (b :: _ as rest) -> (a, b) :: edges first rest
  | [ last ] -> [ (last, first) ]
  | [] -> []

let walls outline =
  let all = edges (List.hd outline) outline in
  List.map (fun (a, b) -> not (List.mem (b, a) all)) all

let drawn_out first (left, outline) =
  let count = List.length outline in
  let side z =
    List.iter
      (fun (x, y) -> vertex (left +. float_of_int x, float_of_int y, z))
      outline
  and front k = first + (k mod count) in
  let back k = front k + count in
  side 0.;
  side 1.5;
  let all = List.init count Fun.id in
  face (List.rev_map front all);
  face (List.map back all);
  List.iteri
    (fun k is_wall ->
      if is_wall then face [ front k; front (k + 1); back (k + 1); back k ])
    (walls outline);
  first + (2 * count)

(* {1 Hills: z is up and y away, as many programs have it; in binary} *)

let hills ~side =
  let count = side + 1 and out = Buffer.create 1024 in
  Printf.bprintf out
    "ply\n\
     format binary_little_endian 1.0\n\
     element vertex %d\n\
     property float x\n\
     property float y\n\
     property float z\n\
     element face %d\n\
     property list uchar ushort vertex_indices\n\
     end_header\n"
    (count * count) (side * side);
  let single x = Buffer.add_int32_le out (Int32.bits_of_float x) in
  let place k = 8. *. ((float_of_int k /. float_of_int side) -. 0.5) in
  for i = 0 to side do
    for j = 0 to side do
      let x = place i and y = place j in
      single x;
      single y;
      single (1.6 *. Noise.turbulence (0.5 *. x) (0.5 *. y) 0.3 4)
    done
  done;
  for i = 0 to side - 1 do
    for j = 0 to side - 1 do
      let at i j = Buffer.add_uint16_le out ((i * count) + j) in
      Buffer.add_uint8 out 4;
      at i j;
      at (i + 1) j;
      at (i + 1) (j + 1);
      at i (j + 1)
    done
  done;
  print_string (Buffer.contents out)

let () =
  match Sys.argv with
  | [| _; "knot" |] -> closed (tube knot 0.24) ~us:120 ~vs:12
  | [| _; "coarse-knot" |] -> closed (tube knot 0.24) ~us:40 ~vs:8
  | [| _; "fir" |] -> turned fir ~sides:9
  | [| _; "letters" |] -> ignore (List.fold_left drawn_out 1 letters : int)
  | [| _; "hills" |] -> hills ~side:48
  | _ -> prerr_endline "say which: knot, coarse-knot, fir, letters, hills"

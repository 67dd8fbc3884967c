open Raylab_geometry

let sentence objects (k, l) =
  let first : Object.t = objects.(k) and second : Object.t = objects.(l) in
  let text =
    Printf.sprintf "%s is where %s is: they hide each other"
      (Warning.name (l + 1) second)
      (Warning.name (k + 1) first)
  in
  { Warning.text; about = [ first.origin; second.origin ] }

let place (o : Object.t) = Shape.place o.shape

(* Of all numbers: what is changed or put together may begin alike. *)
let hash o =
  let place = place o in
  let count = Array.length place in
  Hashtbl.hash_param count count place

let same a b = compare (place a) (place b) = 0

(* At least twice as many as there are objects, and a power of two. *)
let table_size count =
  let rec from size = if size >= 2 * count then size else from (2 * size) in
  from 16

(* There may be millions of objects. So their places are not kept, but worked
   out again where two may be the same. *)
let warnings objects =
  let objects = Array.of_list objects in
  let hashes = Array.map hash objects in
  let size = table_size (Array.length objects) in
  let table = Array.make size (-1) in
  let rec first_with k slot =
    let first = table.(slot) in
    if first < 0 then (
      table.(slot) <- k;
      None)
    else if hashes.(first) = hashes.(k) && same objects.(first) objects.(k)
    then Some (first, k)
    else first_with k ((slot + 1) land (size - 1))
  in
  let twin_of k = first_with k (hashes.(k) land (size - 1)) in
  Seq.take (Array.length objects) (Seq.ints 0)
  |> Seq.filter_map twin_of |> List.of_seq
  |> Warning.few "object" (sentence objects)

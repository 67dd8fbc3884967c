let coordinate (f : Facets.t) point axis = f.points.((3 * point) + axis)

(* The same for -0 and 0. *)
let hash facets point =
  let bits axis = Hashtbl.hash (coordinate facets point axis +. 0.) in
  bits 0 + (31 * (bits 1 + (31 * bits 2)))

let in_one_place facets a b =
  coordinate facets a 0 = coordinate facets b 0
  && coordinate facets a 1 = coordinate facets b 1
  && coordinate facets a 2 = coordinate facets b 2

let places (facets : Facets.t) =
  let count = Array.length facets.points / 3 in
  let buckets = Array.make (Int.max 1 count) (-1) in
  let next = Array.make count (-1) and places = Array.make count 0 in
  for point = 0 to count - 1 do
    let bucket = hash facets point land 0x3FFFFFFF mod count in
    let rec find other =
      if other = -1 then (
        next.(point) <- buckets.(bucket);
        buckets.(bucket) <- point;
        point)
      else if in_one_place facets point other then other
      else find next.(other)
    in
    places.(point) <- find buckets.(bucket)
  done;
  places

type edge = { triangle : int; side : int; faces : int }

(* Edges go by the lower of their two ends: [heads] has the last edge of each
   point, [next] the edge before each. *)
let open_edge (facets : Facets.t) ~places =
  let count = Array.length facets.corners in
  let heads = Array.make (Array.length places) (-1) in
  let next = Array.make count (-1) in
  let far = Array.make count (-1) and faces = Array.make count 0 in
  let low_and_high edge =
    let first = edge - (edge mod 3) in
    let a = places.(facets.corners.(edge))
    and b = places.(facets.corners.(first + ((edge + 1) mod 3))) in
    (Int.min a b, Int.max a b)
  in
  let rec find edge high =
    if edge = -1 || far.(edge) = high then edge else find next.(edge) high
  in
  for edge = 0 to count - 1 do
    let low, high = low_and_high edge in
    let known = find heads.(low) high in
    if known <> -1 then faces.(known) <- faces.(known) + 1
    else (
      far.(edge) <- high;
      faces.(edge) <- 1;
      next.(edge) <- heads.(low);
      heads.(low) <- edge)
  done;
  let rec first_open edge =
    if edge = count then None
    else if faces.(edge) <> 0 && faces.(edge) <> 2 then
      Some { triangle = edge / 3; side = edge mod 3; faces = faces.(edge) }
    else first_open (edge + 1)
  in
  first_open 0

let point facets k =
  Vec3.make (coordinate facets k 0) (coordinate facets k 1)
    (coordinate facets k 2)

let fold_triangles (facets : Facets.t) start add =
  let sum = ref start in
  for triangle = 0 to Facets.count facets - 1 do
    let corner k = point facets facets.corners.((3 * triangle) + k) in
    sum := add !sum (corner 0) (corner 1) (corner 2)
  done;
  !sum

(* The sum of the tetrahedra between the point and each triangle. *)
let volume facets ~apex =
  let add sum a b c =
    let from p = Vec3.sub p apex in
    sum +. Vec3.dot (from a) (Vec3.cross (from b) (from c))
  in
  fold_triangles facets 0. add /. 6.

let area facets =
  let add (sum, whole) a b c =
    let twice = Vec3.cross (Vec3.sub b a) (Vec3.sub c a) in
    let area = Vec3.scale 0.5 twice in
    (Vec3.add sum area, whole +. Vec3.length area)
  in
  fold_triangles facets (Vec3.zero, 0.) add

open Raylab_tracer

type t = {
  picture : Picture.t;
  passes_done : Bytes.t; (* a set of bits for each tile *)
  mutable pixels_known : int;
}

let size_of picture = (Picture.width picture, Picture.height picture)
let picture r = r.picture
let size r = size_of r.picture

let with_passes bits picture =
  let width, height = size_of picture in
  Bytes.make (Tile.count ~width ~height) (Char.chr bits)

let pass_count = Array.length Pass.coarse_to_fine
let all_passes = (1 lsl pass_count) - 1

let start picture =
  { picture; passes_done = with_passes 0 picture; pixels_known = 0 }

let complete picture =
  let width, height = size_of picture in
  {
    picture;
    passes_done = with_passes all_passes picture;
    pixels_known = width * height;
  }

let tile_at r x y =
  let across = (Picture.width r.picture + Tile.side - 1) / Tile.side in
  (y / Tile.side * across) + (x / Tile.side)

let bit pass =
  let rec find k =
    if Pass.coarse_to_fine.(k) = pass then k else find (k + 1)
  in
  1 lsl find 0

let note r pass (tile : Tile.t) =
  let k = tile_at r tile.left tile.top in
  let known = Bytes.get_uint8 r.passes_done k in
  Bytes.set_uint8 r.passes_done k (known lor bit pass);
  r.pixels_known <- r.pixels_known + Pass.pixels pass tile

let part r =
  let width, height = size r in
  float_of_int r.pixels_known /. float_of_int (width * height)

(* The step after the passes of a set: a pass counts only if those before it are
   done as well. 0: nothing is known. *)
let step_of =
  Array.init (all_passes + 1) (fun set ->
      let rec finest k step =
        if k < pass_count && set land (1 lsl k) <> 0 then
          finest (k + 1) (Pass.step Pass.coarse_to_fine.(k))
        else step
      in
      finest 0 0)

let color r ~x ~y =
  match step_of.(Bytes.get_uint8 r.passes_done (tile_at r x y)) with
  | 0 -> None
  | step ->
      let snap v = v land lnot (step - 1) in
      let red, green, blue = Picture.get r.picture ~x:(snap x) ~y:(snap y) in
      Some ((red lsl 16) lor (green lsl 8) lor blue)

open Raylab_tracer

(* Both arrays have an entry for each square of {!Tile.side}. *)
type t = {
  picture : Picture.t;
  passes : Pass.t array;
  passes_done : int array;  (** a set of bits *)
  steps : int array;  (** {!step} *)
  mutable squares_known : int;  (** those whose step is not 0 *)
  pixels : float;  (** of all passes *)
  mutable pixels_known : float;
}

let picture r = r.picture
let size r = (Picture.width r.picture, Picture.height r.picture)

let make picture ~passes ~step ~pixels ~pixels_known =
  let width = Picture.width picture and height = Picture.height picture in
  let squares = Tile.count ~side:Tile.side ~width ~height in
  {
    picture;
    passes;
    passes_done = Array.make squares 0;
    steps = Array.make squares step;
    squares_known = (if step = 0 then 0 else squares);
    pixels;
    pixels_known;
  }

let pixels pass tile = float_of_int (Pass.pixels pass tile)

let start ~passes picture =
  let width = Picture.width picture and height = Picture.height picture in
  let add sum pass = sum +. pixels pass { left = 0; top = 0; width; height } in
  let pixels = Array.fold_left add 0. passes in
  make picture ~passes ~step:0 ~pixels ~pixels_known:0.

let complete picture =
  make picture ~passes:[||] ~step:1 ~pixels:1. ~pixels_known:1.

let across r = (Picture.width r.picture + Tile.side - 1) / Tile.side
let square_at r x y = (y / Tile.side * across r) + (x / Tile.side)

let bit r pass =
  let rec find k = if r.passes.(k) = pass then k else find (k + 1) in
  1 lsl find 0

(* The step after a set of passes, those before pass [k] having led to [step]: a
   pass counts only if those before it are done as well. *)
let rec step_after passes set k step =
  if set land (1 lsl k) = 0 then step
  else step_after passes set (k + 1) (Pass.step passes.(k))

(* Nothing is allocated: coarse tiles of a large picture have very many squares,
   and a collection stops the domains that render. *)
let note_square r bit k =
  let set = r.passes_done.(k) lor bit in
  let before = r.steps.(k) and after = step_after r.passes set 0 0 in
  r.passes_done.(k) <- set;
  r.steps.(k) <- after;
  if before = 0 && after > 0 then r.squares_known <- r.squares_known + 1

let note r pass (tile : Tile.t) =
  let bit = bit r pass in
  let first = square_at r tile.left tile.top and across = across r in
  for j = 0 to (tile.height - 1) / Tile.side do
    for i = 0 to (tile.width - 1) / Tile.side do
      note_square r bit (first + (j * across) + i)
    done
  done;
  r.pixels_known <- r.pixels_known +. pixels pass tile

let part r = r.pixels_known /. r.pixels
let is_covered r = r.squares_known = Array.length r.steps
let step r ~x ~y = r.steps.(square_at r x y)

let color r ~x ~y =
  let mask = -Int.max 1 (step r ~x ~y) in
  Picture.code r.picture ~x:(x land mask) ~y:(y land mask)

open Raylab_scene

type area = { left : int; top : int; columns : int; rows : int }

(* A bound of each channel of what was taken, and the sum. *)
type range = { low : Raw_color.t; high : Raw_color.t; sum : Raw_color.t }

type t = {
  evaluator : Evaluator.t;
  film : Film.t;
  whole : area;
  mutable area : area;  (** of which the centres are known *)
  exposed : float array;  (** three channels of each of these *)
  shown : float array;  (** the same, encoded *)
  over : Bytes.t;  (** whether they are over-exposed *)
  range : range;
  mutable taken : int;
}

let threshold = 1. /. 32.
let largest_side = 32
let nowhere = { left = 0; top = 0; columns = 0; rows = 0 }

let create prepared =
  let { Scene.film; camera = { width; height; _ }; _ } =
    prepared.Prepared.scene
  in
  let side = if film.samples = 1 then 0 else largest_side + 2 in
  let channels () = Array.make (3 * side * side) 0. in
  {
    evaluator = Evaluator.create prepared;
    film;
    whole = { left = 0; top = 0; columns = width; rows = height };
    area = nowhere;
    exposed = channels ();
    shown = channels ();
    over = Bytes.create (side * side);
    range =
      {
        low = Raw_color.create ();
        high = Raw_color.create ();
        sum = Raw_color.create ();
      };
    taken = 0;
  }

let tally t = Evaluator.tally t.evaluator

(* {1 Centres} *)

let sample t ~x ~y k = Evaluator.sample t.evaluator ~x ~y k
let centre t ~x ~y = Film.expose t.film (sample t ~x ~y 0)
let index { left; top; columns; _ } x y = ((y - top) * columns) + x - left

let keep t at color =
  let over = Film.over_exposed t.film color in
  Bytes.set_uint8 t.over at (Bool.to_int over);
  let { Color.r; g; b } = Film.expose t.film color and at = 3 * at in
  t.exposed.(at) <- r;
  t.exposed.(at + 1) <- g;
  t.exposed.(at + 2) <- b;
  t.shown.(at) <- Film.channel t.film r;
  t.shown.(at + 1) <- Film.channel t.film g;
  t.shown.(at + 2) <- Film.channel t.film b

(* [around area whole] is [area] and the pixels beside it, in [whole]. *)
let around { left; top; columns; rows } whole =
  let first at = Int.max 0 (at - 1) in
  let last at count all = Int.min all (at + count + 1) in
  let left' = first left and top' = first top in
  {
    left = left';
    top = top';
    columns = last left columns whole.columns - left';
    rows = last top rows whole.rows - top';
  }

let never () = false

let prepare ?(stop = never) t { Tile.left; top; width; height } =
  if t.film.samples > 1 then (
    let tile = { left; top; columns = width; rows = height } in
    let ({ left; top; columns; rows } as area) = around tile t.whole in
    t.area <- area;
    for y = top to top + rows - 1 do
      for x = left to left + columns - 1 do
        if not (stop ()) then keep t (index area x y) (sample t ~x ~y 0)
      done
    done)

(* {1 Differences} *)

let[@inline] apart a b = Float.abs (a -. b)

(* How much two centres differ, as shown. *)
let difference { shown; _ } a b =
  let channel k = apart shown.((3 * a) + k) shown.((3 * b) + k) in
  Float.max (channel 0) (Float.max (channel 1) (channel 2))

let around_pixel t x y =
  around { left = x; top = y; columns = 1; rows = 1 } t.whole

let has_other_neighbour t x y =
  let { left; top; columns; rows } = around_pixel t x y in
  let here = index t.area x y in
  let differs = ref false in
  for y = top to top + rows - 1 do
    for x = left to left + columns - 1 do
      if difference t here (index t.area x y) > threshold then differs := true
    done
  done;
  !differs

let differ t =
  let { low; high; _ } = t.range in
  let channel low high =
    Film.channel t.film high -. Film.channel t.film low > threshold
  in
  channel low.r high.r || channel low.g high.g || channel low.b high.b

(* {1 Pixels} *)

let start { exposed; range = { low; high; sum }; _ } at =
  let r = exposed.(3 * at)
  and g = exposed.((3 * at) + 1)
  and b = exposed.((3 * at) + 2) in
  Raw_color.set low r g b;
  Raw_color.set high r g b;
  Raw_color.set sum r g b

let add { range = { low; high; sum }; _ } { Color.r; g; b } =
  Raw_color.set low (Float.min low.r r) (Float.min low.g g) (Float.min low.b b);
  Raw_color.set high (Float.max high.r r) (Float.max high.g g)
    (Float.max high.b b);
  Raw_color.set sum (sum.r +. r) (sum.g +. g) (sum.b +. b)

(* [taken] samples are taken; whether one was over-exposed. *)
let rec take t x y ~taken ~upto over =
  let over = ref over in
  for k = taken to upto - 1 do
    let color = sample t ~x ~y k in
    if Film.over_exposed t.film color then over := true;
    add t (Film.expose t.film color)
  done;
  t.taken <- upto;
  let most = t.film.samples in
  if upto < most && differ t then
    take t x y ~taken:upto ~upto:(Int.min most (2 * upto)) !over
  else !over

let count t over =
  let tally = tally t in
  tally.samples <- tally.samples + t.taken;
  if over then tally.over_exposed <- tally.over_exposed + 1

let only t ~x ~y =
  let color = sample t ~x ~y 0 in
  t.taken <- 1;
  count t (Film.over_exposed t.film color);
  Film.expose t.film color

let mean t =
  let { sum; _ } = t.range and n = float_of_int t.taken in
  Color.make (sum.r /. n) (sum.g /. n) (sum.b /. n)

let pixel t ~x ~y =
  let most = t.film.samples in
  if most = 1 then only t ~x ~y
  else
    let at = index t.area x y in
    let over = Bytes.get_uint8 t.over at = 1 in
    start t at;
    t.taken <- 1;
    let over =
      if has_other_neighbour t x y then
        take t x y ~taken:1 ~upto:(Int.min 4 most) over
      else over
    in
    count t over;
    mean t

let taken t = t.taken

let lone_pixel t ~x ~y =
  prepare t { left = x; top = y; width = 1; height = 1 };
  pixel t ~x ~y

(* {1 Why there were several} *)

type neighbour = { x : int; y : int; color : Color.t }

let exposed t at =
  Color.make
    t.exposed.(3 * at)
    t.exposed.((3 * at) + 1)
    t.exposed.((3 * at) + 2)

let cause t ~x ~y =
  let { left; top; columns; rows } = around_pixel t x y in
  let here = index t.area x y in
  let nearer best (y, x) =
    let at = index t.area x y in
    let d = difference t here at in
    match best with
    | Some (most, _) when d <= most -> best
    | _ when d > threshold -> Some (d, { x; y; color = exposed t at })
    | _ -> best
  in
  if t.film.samples = 1 then None
  else
    Seq.product
      (Seq.take rows (Seq.ints top))
      (Seq.take columns (Seq.ints left))
    |> Seq.fold_left nearer None |> Option.map snd

open Raylab_scene

type area = { left : int; top : int; columns : int; rows : int }

type t = {
  film : Film.t;
  whole : area;
  mutable area : area;  (** of which the centres are known *)
  exposed : float array;  (** three channels of each of these *)
  shown : float array;  (** the same, encoded *)
  over : Bytes.t;  (** whether they are over-exposed *)
}

let largest_side = 32

let create (film : Film.t) { Camera.width; height; _ } =
  let side = if film.samples = 1 then 0 else largest_side + 2 in
  let channels () = Array.make (3 * side * side) 0. in
  {
    film;
    whole = { left = 0; top = 0; columns = width; rows = height };
    area = { left = 0; top = 0; columns = 0; rows = 0 };
    exposed = channels ();
    shown = channels ();
    over = Bytes.create (side * side);
  }

let index { area = { left; top; columns; _ }; _ } x y =
  ((y - top) * columns) + x - left

let color t ~x ~y =
  let at = 3 * index t x y in
  Color.make t.exposed.(at) t.exposed.(at + 1) t.exposed.(at + 2)

let is_over_exposed t ~x ~y = Bytes.get_uint8 t.over (index t x y) = 1

(* {1 Filling} *)

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

let fill ~stop t { Tile.left; top; width; height } trace =
  let tile = { left; top; columns = width; rows = height } in
  let { left; top; columns; rows } = around tile t.whole in
  t.area <- { left; top; columns; rows };
  for y = top to top + rows - 1 do
    for x = left to left + columns - 1 do
      if not (stop ()) then keep t (index t x y) (trace ~x ~y)
    done
  done

(* {1 Differences} *)

let threshold = 1. /. 32.

(* How much two centres differ, as shown. *)
let difference { shown; _ } a b =
  let channel k = Float.abs (shown.((3 * a) + k) -. shown.((3 * b) + k)) in
  Float.max (channel 0) (Float.max (channel 1) (channel 2))

let around_pixel t x y =
  around { left = x; top = y; columns = 1; rows = 1 } t.whole

let has_other_neighbour t ~x ~y =
  let { left; top; columns; rows } = around_pixel t x y in
  let here = index t x y in
  let differs = ref false in
  for y = top to top + rows - 1 do
    for x = left to left + columns - 1 do
      if difference t here (index t x y) > threshold then differs := true
    done
  done;
  !differs

type neighbour = { x : int; y : int; color : Color.t }

let most_different t ~x ~y =
  let { left; top; columns; rows } = around_pixel t x y in
  let here = index t x y in
  let farther best (y, x) =
    let d = difference t here (index t x y) in
    match best with
    | Some (most, _) when d <= most -> best
    | _ when d > threshold -> Some (d, { x; y; color = color t ~x ~y })
    | _ -> best
  in
  Seq.product (Seq.take rows (Seq.ints top)) (Seq.take columns (Seq.ints left))
  |> Seq.fold_left farther None |> Option.map snd

open Raylab_scene

(* A bound of each channel of what was taken, and the sum. *)
type range = { low : Raw_color.t; high : Raw_color.t; sum : Raw_color.t }

type t = {
  evaluator : Evaluator.t;
  film : Film.t;
  centres : Centres.t;
  range : range;
  mutable taken : int;
}

let create prepared =
  let { Scene.film; camera; _ } = prepared.Prepared.scene in
  {
    evaluator = Evaluator.create prepared;
    film;
    centres = Centres.create film camera;
    range =
      {
        low = Raw_color.create ();
        high = Raw_color.create ();
        sum = Raw_color.create ();
      };
    taken = 0;
  }

let tally t = Evaluator.tally t.evaluator
let sample t ~x ~y k = Evaluator.sample t.evaluator ~x ~y k
let centre t ~x ~y = Film.expose t.film (sample t ~x ~y 0)
let never () = false

let prepare ?(stop = never) t tile =
  if t.film.samples > 1 then
    Centres.fill ~stop t.centres tile (fun ~x ~y -> sample t ~x ~y 0)

(* {1 What was taken} *)

let start { range = { low; high; sum }; _ } { Color.r; g; b } =
  Raw_color.set low r g b;
  Raw_color.set high r g b;
  Raw_color.set sum r g b

let add { range = { low; high; sum }; _ } { Color.r; g; b } =
  Raw_color.set low (Float.min low.r r) (Float.min low.g g) (Float.min low.b b);
  Raw_color.set high (Float.max high.r r) (Float.max high.g g)
    (Float.max high.b b);
  Raw_color.set sum (sum.r +. r) (sum.g +. g) (sum.b +. b)

(* Whether two of them differ: encoding keeps the order. *)
let differ t =
  let { low; high; _ } = t.range in
  let channel low high =
    Film.channel t.film high -. Film.channel t.film low > Centres.threshold
  in
  channel low.r high.r || channel low.g high.g || channel low.b high.b

let mean t =
  let { sum; _ } = t.range and n = float_of_int t.taken in
  Color.make (sum.r /. n) (sum.g /. n) (sum.b /. n)

(* {1 Pixels} *)

(* Takes further samples of a pixel: those from [t.taken] to [upto], and more
   while they differ. Whether one was over-exposed. *)
let rec take t ~x ~y ~upto over =
  let over = ref over in
  for k = t.taken to upto - 1 do
    let color = sample t ~x ~y k in
    if Film.over_exposed t.film color then over := true;
    add t (Film.expose t.film color)
  done;
  t.taken <- upto;
  let most = t.film.samples in
  if upto < most && differ t then
    take t ~x ~y ~upto:(Int.min most (2 * upto)) !over
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

let some t ~x ~y =
  start t (Centres.color t.centres ~x ~y);
  t.taken <- 1;
  let over = Centres.is_over_exposed t.centres ~x ~y in
  count t
    (if Centres.has_other_neighbour t.centres ~x ~y then
       take t ~x ~y ~upto:(Int.min 4 t.film.samples) over
     else over);
  mean t

let pixel t ~x ~y = if t.film.samples = 1 then only t ~x ~y else some t ~x ~y
let taken t = t.taken

let lone_pixel t ~x ~y =
  prepare t { left = x; top = y; width = 1; height = 1 };
  pixel t ~x ~y

let cause t ~x ~y =
  if t.film.samples = 1 then None else Centres.most_different t.centres ~x ~y

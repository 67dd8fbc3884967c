open Bigarray
open Unchecked

(* outside of the heap, which collections go through *)
type ints = (int, int_elt, c_layout) Array1.t

type t = {
  scale : float array; (* u0 u_scale v0 v_scale d0 d_scale columns rows *)
  columns : int;
  starts : ints; (* where the references of each cell start *)
  references : ints; (* or, of a part, lnot its number *)
  parts : t array; (* the finer grids of crowded cells *)
}

let ints length : ints =
  let ints = Array1.create Int C_layout length in
  Array1.fill ints 0;
  ints

let nothing =
  {
    scale = [| 0.; 0.; 0.; 0.; 0.; 0.; 0.; 0. |];
    columns = 0;
    starts = ints 1;
    references = ints 0;
    parts = [||];
  }

let rec length { references; parts; _ } =
  Array.fold_left
    (fun sum part -> sum + length part)
    (Array1.dim references) parts

(* {1 Making them} *)

type making = {
  frame : Fan_view.frame;
  leaves : Leaves.t;
  margin : float;
  view : Fan_view.t;
}

let see { frame; leaves; margin; view } ~window place =
  Fan_view.see frame leaves place ~margin ~window view

(* {2 How large it is} *)

(* What is seen of all: areas, lengths of sides, and the window around them. *)
type survey = {
  mutable area : float;
  mutable rim : float;
  mutable most_depth : float;
  around : Fan_view.t;
}

let add { Fan_view.least_u; most_u; least_v; most_v; depth; _ } survey =
  let { around; _ } = survey in
  let width = most_u -. least_u and height = most_v -. least_v in
  survey.area <- survey.area +. (width *. height);
  survey.rim <- survey.rim +. width +. height;
  if least_u < around.least_u then around.least_u <- least_u;
  if most_u > around.most_u then around.most_u <- most_u;
  if least_v < around.least_v then around.least_v <- least_v;
  if most_v > around.most_v then around.most_v <- most_v;
  if depth < around.depth then around.depth <- depth;
  if depth > survey.most_depth then survey.most_depth <- depth

(* Those of [places] that are seen, and how large they are. *)
let survey making ~window places =
  let survey =
    {
      area = 0.;
      rim = 0.;
      most_depth = neg_infinity;
      around =
        {
          (Fan_view.create ()) with
          least_u = infinity;
          most_u = neg_infinity;
          least_v = infinity;
          most_v = neg_infinity;
          depth = infinity;
        };
    }
  in
  let is_seen place =
    let seen = see making ~window place in
    if seen then add making.view survey;
    seen
  in
  let seen = Array.of_seq (Seq.filter is_seen (Array.to_seq places)) in
  (seen, survey)

let references_a_leaf = 3.
let fewest_cells = 1024.
let most_cells_a_leaf = 4.
let longest_side = 32767

let most_cells count =
  Float.max fewest_cells (most_cells_a_leaf *. float_of_int count)

(* How many cells are as long as 1. A rectangle of w x h lies in about
   (w x + 1) (h x + 1) of them; the x for which that is [references_a_leaf] in
   the mean. *)
let cells_a_unit { area; rim; _ } count width height =
  let n = float_of_int count in
  let wanted = n *. (references_a_leaf -. 1.) in
  let x =
    (sqrt ((rim *. rim) +. (4. *. wanted *. area)) -. rim) /. (2. *. area)
  in
  let most = most_cells count in
  let extent = width *. height in
  if not (extent > 0. && extent < infinity) then 0.
  else if x *. x *. extent <= most then Float.max x (1. /. sqrt extent)
  else sqrt (most /. extent)

(* {2 Cells} *)

(* A grid without references. *)
let grid survey count ~coarser =
  let { Fan_view.least_u; most_u; least_v; most_v; depth; _ } =
    survey.around
  in
  let width = Float.max (most_u -. least_u) 1e-300
  and height = Float.max (most_v -. least_v) 1e-300 in
  let x = cells_a_unit survey count width height in
  let longest = Int.min longest_side (int_of_float (most_cells count)) in
  let side length =
    let cells = ceil (length *. x) in
    let cells =
      if cells < float_of_int longest then int_of_float cells else longest
    in
    Int.max 1 (cells / coarser)
  in
  let columns = side width and rows = side height in
  (* a little more on both sides, as in [rectangle] *)
  let scale cells length = float_of_int cells /. (length *. (1. +. 4e-9)) in
  let slices = float_of_int (Fan_reference.slices - 2) in
  let thickness = Float.max (survey.most_depth -. depth) 1e-300 in
  {
    nothing with
    scale =
      [|
        least_u -. (2e-9 *. width);
        scale columns width;
        least_v -. (2e-9 *. height);
        scale rows height;
        depth;
        slices /. thickness;
        float_of_int columns;
        float_of_int rows;
      |];
    columns;
    starts = ints ((columns * rows) + 1);
  }

let[@inline] cell x start scale count =
  let c = (x -. start) *. scale in
  if c > 0. then Int.min (int_of_float c) (count - 1) else 0

(* A rectangle of cells, in one number. *)
let rectangle { scale = s; columns; starts; _ } (view : Fan_view.t) =
  let rows = Array1.dim starts / columns in
  let pad_u = 1e-9 /. s.%(1) *. s.%(6) and pad_v = 1e-9 /. s.%(3) *. s.%(7) in
  let column u = cell u s.%(0) s.%(1) columns
  and row v = cell v s.%(2) s.%(3) rows in
  let first_column = column (view.least_u -. pad_u)
  and last_column = column (view.most_u +. pad_u)
  and first_row = row (view.least_v -. pad_v)
  and last_row = row (view.most_v +. pad_v) in
  (((((first_column lsl 15) lor last_column) lsl 15) lor first_row) lsl 15)
  lor last_row

let[@inline] iter_cells { columns; _ } rectangle f =
  let first_column = rectangle lsr 45
  and last_column = (rectangle lsr 30) land 0x7fff in
  for row = (rectangle lsr 15) land 0x7fff to rectangle land 0x7fff do
    for column = first_column to last_column do
      f ((row * columns) + column) column row
    done
  done

(* {2 References} *)

(* Makes the count of each cell where its references start; the sum of all. *)
let add_up (starts : ints) =
  let sum = ref 0 in
  for i = 0 to Array1.dim starts - 1 do
    let count = starts.{i} in
    starts.{i} <- !sum;
    sum := !sum + count
  done;
  !sum

let rectangles making face ~window seen =
  let { starts; _ } = face in
  let rectangle place =
    ignore (see making ~window place);
    let rectangle = rectangle face making.view in
    iter_cells face rectangle (fun i _ _ -> starts.{i} <- starts.{i} + 1);
    rectangle
  in
  Array.map rectangle seen

(* In units of a disc from the first corner of all cells. *)
let units x start scale =
  let units = (x -. start) *. scale *. Fan_reference.fine in
  if abs_float units < 1e8 then int_of_float (Float.round units)
  else Fan_reference.far

let fill making face ~window seen rectangles (references : ints) =
  let { scale = s; starts; _ } = face and { view; _ } = making in
  let unit = Fan_reference.units in
  let largest = Float.max s.%(1) s.%(3) *. Fan_reference.fine in
  let add k place =
    ignore (see making ~window place);
    let u = units view.u s.%(0) s.%(1) and v = units view.v s.%(2) s.%(3) in
    let slice = (view.depth -. s.%(4)) *. s.%(5)
    and radius = view.radius *. largest in
    iter_cells face rectangles.(k) (fun i column row ->
        references.{starts.{i}} <-
          Fan_reference.make ~slice ~place
            ~u:(u - (unit * column))
            ~v:(v - (unit * row))
            ~radius;
        starts.{i} <- starts.{i} + 1)
  in
  Array.iteri add seen;
  (* each now stands where the next cell starts *)
  for i = Array1.dim starts - 1 downto 1 do
    starts.{i} <- starts.{i - 1}
  done;
  starts.{0} <- 0

(* By insertion: cells have few, or a part. *)
let sort_few (a : ints) first stop =
  for i = first + 1 to stop - 1 do
    let x = a.{i} in
    let j = ref (i - 1) in
    while !j >= first && a.{!j} > x do
      a.{!j + 1} <- a.{!j};
      decr j
    done;
    a.{!j + 1} <- x
  done

let sort (a : ints) first stop =
  if stop - first <= 48 then sort_few a first stop
  else
    let part = Array.init (stop - first) (fun k -> a.{first + k}) in
    Array.stable_sort Int.compare part;
    Array.iteri (fun k x -> a.{first + k} <- x) part

(* {2 Crowded cells} *)

let crowded = 64
let deepest = 8

(* A little more than the cell. *)
let window_of { scale = s; columns; _ } i : Fan_view.t =
  let e = 1e-6 in
  let row = float_of_int (i / columns)
  and column = float_of_int (i mod columns) in
  let side start scale cells = start +. (cells /. scale) in
  {
    (Fan_view.everything ()) with
    least_u = side s.%(0) s.%(1) (column -. e);
    most_u = side s.%(0) s.%(1) (column +. 1. +. e);
    least_v = side s.%(2) s.%(3) (row -. e);
    most_v = side s.%(2) s.%(3) (row +. 1. +. e);
  }

(* Whether a finer grid has much fewer in a cell: what is seen is small. *)
let is_worth_a_part survey count (window : Fan_view.t) =
  survey.area
  < 0.1 *. float_of_int count
    *. (window.most_u -. window.least_u)
    *. (window.most_v -. window.least_v)

(* The face of [places] in [window], of at most [most] references. *)
let rec make_face making ~window ~level ~most ~coarser places =
  let seen, survey = survey making ~window places in
  let count = Array.length seen in
  if count = 0 then Some nothing
  else
    let face = grid survey count ~coarser in
    let rectangles = rectangles making face ~window seen in
    let sum = add_up face.starts in
    if sum <= most then (
      let references = ints sum in
      fill making face ~window seen rectangles references;
      Some
        (with_parts making ~level ~most:(most - sum) { face with references }))
    else if Array1.dim face.starts = 2 then None
    else
      let coarser = 2 * coarser in
      make_face making ~window ~level ~most ~coarser places

and with_parts making ~level ~most face =
  let { references; starts; _ } = face in
  let parts = ref [] and count = ref 0 and left = ref most in
  let part first stop i =
    if stop - first <= crowded || level = deepest then None
    else
      let places =
        Array.init (stop - first) (fun k ->
            Fan_reference.place references.{first + k})
      and window = window_of face i in
      let _, survey = survey making ~window places in
      if is_worth_a_part survey (Array.length places) window then
        make_face making ~window ~level:(level + 1) ~most:!left ~coarser:1
          places
      else None
  in
  for i = 0 to Array1.dim starts - 2 do
    let first = starts.{i} and stop = starts.{i + 1} in
    match part first stop i with
    | None -> sort references first stop
    | Some part ->
        references.{first} <- lnot !count;
        incr count;
        left := !left - length part;
        parts := part :: !parts
  done;
  { face with parts = Array.of_list (List.rev !parts) }

let extent (frame : Fan_view.frame) (leaves : Leaves.t) =
  Array.fold_left
    (fun most x -> Float.max most (abs_float x))
    leaves.extent frame.origin

(* What is added to the size of all: far more than the rounding errors of a ray
   that comes from up to 1e4 times as far. *)
let margin = 1e-10

let make frame leaves ~window ~most =
  let margin = margin *. extent frame leaves in
  let making = { frame; leaves; margin; view = Fan_view.create () } in
  make_face making ~window ~level:0 ~most ~coarser:1
    (Array.init (Leaves.count leaves) Fun.id)

(* {1 Questions} *)

(* The part of the face in which the ray is, and its place there. *)
let[@inline always] meet ~any face leaves ~u ~v ~pace ~depth (ray : Raw_ray.t)
    (meeting : Meeting.t) =
  let face = ref face and goes_on = ref true in
  while !goes_on do
    let { scale = s; starts; references; columns; _ } = !face in
    let c = (u -. s.%(0)) *. s.%(1) and r = (v -. s.%(2)) *. s.%(3) in
    goes_on := false;
    if c >= 0. && r >= 0. && c < s.%(6) && r < s.%(7) then
      let column = int_of_float c and row = int_of_float r in
      let cell = (row * columns) + column in
      let first = Array1.unsafe_get starts cell
      and stop = Array1.unsafe_get starts (cell + 1) in
      if first < stop then
        let head = Array1.unsafe_get references first in
        if head < 0 then (
          face := Array.unsafe_get !face.parts (lnot head);
          goes_on := true)
        else
          let u =
            int_of_float ((c *. Fan_reference.fine) +. 0.5)
            - (Fan_reference.units * column)
          and v =
            int_of_float ((r *. Fan_reference.fine) +. 0.5)
            - (Fan_reference.units * row)
          in
          let best = ref ray.reach in
          let limit =
            let along = if any then depth else pace *. !best in
            ref (Fan_reference.beyond ((along -. s.%(4)) *. s.%(5)))
          in
          let k = ref first in
          while !k < stop do
            let reference = Array1.unsafe_get references !k in
            if reference > !limit then k := stop
            else (
              incr k;
              if Fan_reference.may_be_at reference u v then (
                Leaves.offer leaves (Fan_reference.place reference) ray meeting;
                if any then (if not (Meeting.is_none meeting) then k := stop)
                else if ray.reach < !best then (
                  best := ray.reach;
                  limit :=
                    Fan_reference.beyond (((pace *. !best) -. s.%(4)) *. s.%(5)))))
          done
  done

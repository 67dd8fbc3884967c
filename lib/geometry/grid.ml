open Bigarray
open Unchecked

type ints = (int, int_elt, c_layout) Array1.t

type t = {
  bounds : float array; (* low x y z, high x y z, cells a unit on x y z *)
  nx : int;
  ny : int;
  nz : int;
  starts : ints; (* where the references of each cell start *)
  references : ints; (* places of leaves; or, of a part, lnot its number *)
  parts : t array; (* the grids of crowded cells *)
  far : float array; (* one number: the farthest origin of a ray *)
}

(* {1 Making them} *)

type making = {
  leaves : Leaves.t;
  margin : float; (* what leaves are made larger by *)
  mutable left : int; (* how many references there may still be *)
}

(* The sides of what a leaf occupies: 0 to 2 the least, 3 to 5 the greatest. *)
let side { leaves; margin; _ } place k =
  let { Leaves.balls; boxes; _ } = leaves in
  if Leaves.is_ball leaves place then
    let centre = balls.((4 * place) + (k mod 3))
    and r = (balls.((4 * place) + 3) *. (1. +. 1e-9)) +. margin in
    if k < 3 then centre -. r else centre +. r
  else if k < 3 then boxes.((6 * place) + (2 * k)) -. margin
  else boxes.((6 * place) + (2 * (k - 3)) + 1) +. margin

(* The box around leaves, within [window]. *)
let bounds_of making ~window places =
  let bounds =
    Array.init 6 (fun k -> if k < 3 then infinity else neg_infinity)
  in
  let add place =
    for k = 0 to 2 do
      let low = side making place k and high = side making place (k + 3) in
      if low < bounds.(k) then bounds.(k) <- low;
      if high > bounds.(k + 3) then bounds.(k + 3) <- high
    done
  in
  Array.iter add places;
  for k = 0 to 2 do
    if window.(k) > bounds.(k) then bounds.(k) <- window.(k);
    if window.(k + 3) < bounds.(k + 3) then bounds.(k + 3) <- window.(k + 3)
  done;
  bounds

(* The length of the edges of cells, of which there are about [count] in a box
   that may be as thin as one cell. *)
let edge count extents =
  let n = float_of_int count in
  let long = Float.max extents.(0) (Float.max extents.(1) extents.(2)) in
  let part k = Float.max (extents.(k) /. long) 1e-12 in
  let volume = part 0 *. part 1 *. part 2 in
  let thin = Float.min (part 0) (Float.min (part 1) (part 2)) in
  let cube = Float.cbrt (volume /. n) in
  let square = sqrt (volume /. thin /. n) in
  let middle = volume /. thin in
  long
  *.
  if thin >= cube then cube else if middle >= square then square else 1. /. n

let most_on_a_side = 4096

let empty bounds ~count ~coarser =
  let extent k = bounds.(k + 3) -. bounds.(k) in
  let edge = edge count [| extent 0; extent 1; extent 2 |] in
  let cells k =
    let cells = Float.round (extent k /. edge) in
    (* NaN for a point *)
    if not (cells >= 1.) then 1
    else
      let most = float_of_int most_on_a_side in
      Int.max 1 (int_of_float (Float.min cells most) / coarser)
  in
  let nx = cells 0 and ny = cells 1 and nz = cells 2 in
  let scale k cells = float_of_int cells /. extent k in
  let starts = Array1.create Int C_layout ((nx * ny * nz) + 1) in
  Array1.fill starts 0;
  {
    bounds = Array.append bounds [| scale 0 nx; scale 1 ny; scale 2 nz |];
    nx;
    ny;
    nz;
    starts;
    references = Array1.create Int C_layout 0;
    parts = [||];
    far = [| 0. |];
  }

let[@inline] cell bounds k x count =
  let c = (x -. bounds.(k)) *. bounds.(k + 6) in
  if c > 0. then Int.min (int_of_float c) (count - 1) else 0

(* How far [x] is from the cells [c] on the axis [k]. *)
let[@inline] away bounds k x c =
  let low = bounds.(k) +. (float_of_int c /. bounds.(k + 6)) in
  let high = bounds.(k) +. (float_of_int (c + 1) /. bounds.(k + 6)) in
  if x < low then low -. x else if x > high then x -. high else 0.

(* Whether a ball reaches into a cell; what is no ball fills its box. *)
let reaches making { bounds; _ } place cx cy cz =
  let { Leaves.balls; _ } = making.leaves in
  (not (Leaves.is_ball making.leaves place))
  ||
  let at = 4 * place in
  let dx = away bounds 0 balls.(at) cx
  and dy = away bounds 1 balls.(at + 1) cy
  and dz = away bounds 2 balls.(at + 2) cz in
  let r = (balls.(at + 3) *. (1. +. 1e-9)) +. (2. *. making.margin) in
  (dx *. dx) +. (dy *. dy) +. (dz *. dz) <= r *. r

let iter_cells making ({ bounds; nx; ny; nz; _ } as grid) place f =
  let range k count =
    ( cell bounds k (side making place k) count,
      cell bounds k (side making place (k + 3)) count )
  in
  let x0, x1 = range 0 nx and y0, y1 = range 1 ny and z0, z1 = range 2 nz in
  for cz = z0 to z1 do
    for cy = y0 to y1 do
      for cx = x0 to x1 do
        if reaches making grid place cx cy cz then
          f ((((cz * ny) + cy) * nx) + cx)
      done
    done
  done

(* Makes the count of each cell where its references start; the sum of all. *)
let add_up (starts : ints) =
  let sum = ref 0 in
  for i = 0 to Array1.dim starts - 1 do
    let count = starts.{i} in
    starts.{i} <- !sum;
    sum := !sum + count
  done;
  !sum

let fill making ({ starts; _ } as grid) places (references : ints) =
  let add place =
    iter_cells making grid place (fun i ->
        references.{starts.{i}} <- place;
        starts.{i} <- starts.{i} + 1)
  in
  Array.iter add places;
  (* each now stands where the next cell starts *)
  for i = Array1.dim starts - 1 downto 1 do
    starts.{i} <- starts.{i - 1}
  done;
  starts.{0} <- 0

(* {2 Crowded cells} *)

let crowded = 16
let deepest = 8

let window_of { bounds; nx; ny; _ } i =
  let index = [| i mod nx; i / nx mod ny; i / (nx * ny) |] in
  Array.init 6 (fun k ->
      let axis = k mod 3 in
      let at =
        float_of_int index.(axis) +. if k < 3 then -1e-6 else 1. +. 1e-6
      in
      bounds.(axis) +. (at /. bounds.(axis + 6)))

(* Whether what is in the window is small in the mean. *)
let is_worth_a_part making window places =
  let volume place =
    let length k =
      let whole = window.(k + 3) -. window.(k) in
      let length = side making place (k + 3) -. side making place k in
      Float.min 1. (length /. whole)
    in
    length 0 *. length 1 *. length 2
  in
  let sum = Array.fold_left (fun sum place -> sum +. volume place) 0. places in
  sum < 0.1 *. float_of_int (Array.length places)

let rec make_grid making ~window ~level ~coarser places =
  let bounds = bounds_of making ~window places in
  let grid = empty bounds ~count:(Array.length places) ~coarser in
  let count place =
    iter_cells making grid place (fun i ->
        grid.starts.{i} <- grid.starts.{i} + 1)
  in
  Array.iter count places;
  let sum = add_up grid.starts in
  if sum <= making.left then (
    making.left <- making.left - sum;
    let references = Array1.create Int C_layout sum in
    fill making grid places references;
    Some (with_parts making ~level { grid with references }))
  else if Array1.dim grid.starts = 2 then None
  else make_grid making ~window ~level ~coarser:(2 * coarser) places

and with_parts making ~level ({ references; starts; _ } as grid) =
  let parts = ref [] and count = ref 0 in
  let part i =
    let first = starts.{i} and stop = starts.{i + 1} in
    if stop - first > crowded && level < deepest then
      let places = Array.init (stop - first) (fun k -> references.{first + k})
      and window = window_of grid i in
      if is_worth_a_part making window places then
        make_grid making ~window ~level:(level + 1) ~coarser:1 places
      else None
    else None
  in
  for i = 0 to Array1.dim starts - 2 do
    match part i with
    | None -> ()
    | Some part ->
        references.{starts.{i}} <- lnot !count;
        incr count;
        parts := part :: !parts
  done;
  { grid with parts = Array.of_list (List.rev !parts) }

let largest = 1e100
let margin = 1e-10
let farthest = 100.

let make (leaves : Leaves.t) =
  let count = Leaves.count leaves in
  if count = 0 || leaves.extent >= largest then None
  else
    let making =
      {
        leaves;
        margin = (margin *. leaves.extent) +. 1e-280;
        left = 1024 + (8 * count);
      }
    and window =
      Array.init 6 (fun k -> if k < 3 then neg_infinity else infinity)
    in
    make_grid making ~window ~level:0 ~coarser:1 (Array.init count Fun.id)
    |> Option.map (fun grid ->
           { grid with far = [| farthest *. leaves.extent |] })

(* {1 What it costs}

   A line that crosses a box crosses a smaller one in it as often as the areas
   of their surfaces are to each other. *)

let area x y z = (x *. y) +. (y *. z) +. (z *. x)

(* Beside a step of the tree: measured. *)
let step = 0.3
let test = 0.2

let rec cost { bounds = b; nx; ny; nz; starts; references; parts; _ } =
  let extent k = b.(k + 3) -. b.(k) in
  let whole = area (extent 0) (extent 1) (extent 2)
  and cell = area (1. /. b.(6)) (1. /. b.(7)) (1. /. b.(8)) in
  let tests = ref 0 in
  for i = 0 to Array1.dim starts - 2 do
    let first = starts.{i} and stop = starts.{i + 1} in
    if stop > first && references.{first} >= 0 then
      tests := !tests + stop - first
  done;
  let own =
    cell /. whole
    *. ((step *. float_of_int (nx * ny * nz)) +. (test *. float_of_int !tests))
  in
  Array.fold_left
    (fun sum (part : t) ->
      let extent k = part.bounds.(k + 3) -. part.bounds.(k) in
      sum +. (area (extent 0) (extent 1) (extent 2) /. whole *. cost part))
    own parts

(* {1 Questions} *)

let has_ray_from { far; _ } (ray : Raw_ray.t) =
  abs_float ray.ox +. abs_float ray.oy +. abs_float ray.oz < far.%(0)

let[@inline] offer_all leaves (references : ints) first stop ray meeting =
  for k = first to stop - 1 do
    Leaves.offer leaves (Array1.unsafe_get references k) ray meeting
  done

(* Where the ray enters and leaves the slab between two sides, and when it
   leaves the cell [c] on an axis. *)
let rec walk ~any { bounds = f; nx; ny; nz; starts; references; parts; _ }
    leaves (ray : Raw_ray.t) (meeting : Meeting.t) =
  let ox = ray.ox and oy = ray.oy and oz = ray.oz in
  let ix = 1. /. ray.dx and iy = 1. /. ray.dy and iz = 1. /. ray.dz in
  let px = ix >= 0. and py = iy >= 0. and pz = iz >= 0. in
  let start = ref 0. and stop = ref ray.reach in
  let ex = ((if px then f.%(0) else f.%(3)) -. ox) *. ix
  and ey = ((if py then f.%(1) else f.%(4)) -. oy) *. iy
  and ez = ((if pz then f.%(2) else f.%(5)) -. oz) *. iz in
  let qx = ((if px then f.%(3) else f.%(0)) -. ox) *. ix
  and qy = ((if py then f.%(4) else f.%(1)) -. oy) *. iy
  and qz = ((if pz then f.%(5) else f.%(2)) -. oz) *. iz in
  if ex > !start then start := ex;
  if ey > !start then start := ey;
  if ez > !start then start := ez;
  if qx < !stop then stop := qx;
  if qy < !stop then stop := qy;
  if qz < !stop then stop := qz;
  if !start <= !stop then
    let sx = f.%(6) and sy = f.%(7) and sz = f.%(8) in
    let cx = cell f 0 (ox +. (!start *. ray.dx)) nx
    and cy = cell f 1 (oy +. (!start *. ray.dy)) ny
    and cz = cell f 2 (oz +. (!start *. ray.dz)) nz in
    let step_x = if px then 1 else -1
    and step_y = if py then nx else -nx
    and step_z = if pz then nx * ny else -(nx * ny) in
    let left_x = ref (if px then nx - 1 - cx else cx)
    and left_y = ref (if py then ny - 1 - cy else cy)
    and left_z = ref (if pz then nz - 1 - cz else cz) in
    let next_x = float_of_int (if px then cx + 1 else cx)
    and next_y = float_of_int (if py then cy + 1 else cy)
    and next_z = float_of_int (if pz then cz + 1 else cz) in
    let tx = ref ((f.%(0) +. (next_x /. sx) -. ox) *. ix)
    and ty = ref ((f.%(1) +. (next_y /. sy) -. oy) *. iy)
    and tz = ref ((f.%(2) +. (next_z /. sz) -. oz) *. iz) in
    let dx = abs_float (ix /. sx)
    and dy = abs_float (iy /. sy)
    and dz = abs_float (iz /. sz) in
    let i = ref ((((cz * ny) + cy) * nx) + cx) and goes_on = ref true in
    while !goes_on do
      let first = Array1.unsafe_get starts !i
      and stop = Array1.unsafe_get starts (!i + 1) in
      if first < stop then (
        let head = Array1.unsafe_get references first in
        if head < 0 then
          walk ~any (Array.unsafe_get parts (lnot head)) leaves ray meeting
        else offer_all leaves references first stop ray meeting;
        if any && not (Meeting.is_none meeting) then goes_on := false);
      if !goes_on then
        if !tx < !ty && !tx < !tz then
          if ray.reach < !tx || !left_x = 0 then goes_on := false
          else (
            decr left_x;
            i := !i + step_x;
            tx := !tx +. dx)
        else if !ty < !tz then
          if ray.reach < !ty || !left_y = 0 then goes_on := false
          else (
            decr left_y;
            i := !i + step_y;
            ty := !ty +. dy)
        else if ray.reach < !tz || !left_z = 0 then goes_on := false
        else (
          decr left_z;
          i := !i + step_z;
          tz := !tz +. dz)
    done

let nearest grid leaves ray meeting = walk ~any:false grid leaves ray meeting
let some grid leaves ray meeting = walk ~any:true grid leaves ray meeting

open Bigarray

type boxes = (float, float64_elt, c_layout) Array1.t
type kind = Sphere | Other
type t = { boxes : boxes; numbers : int array; kinds : int -> kind }

let create ~kinds count =
  {
    boxes = Array1.create Float64 C_layout (6 * count);
    numbers = Array.init count Fun.id;
    kinds;
  }

let[@inline] set_side { boxes; _ } place side x =
  boxes.{(6 * place) + side} <- x

let set_number { numbers; _ } place number = numbers.(place) <- number
let count { numbers; _ } = Array.length numbers

let[@inline] side { boxes; _ } place side =
  Array1.unsafe_get boxes ((6 * place) + side)

let[@inline] centre leaves place axis =
  (0.5 *. side leaves place (2 * axis))
  +. (0.5 *. side leaves place ((2 * axis) + 1))

let kind { numbers; kinds; _ } place = kinds numbers.(place)

let one_kind leaves first stop =
  let first_kind = kind leaves first in
  let rec all place =
    place = stop || (kind leaves place = first_kind && all (place + 1))
  in
  all first

let swap { boxes; numbers; _ } a b =
  for i = 0 to 5 do
    let kept = boxes.{(6 * a) + i} in
    boxes.{(6 * a) + i} <- boxes.{(6 * b) + i};
    boxes.{(6 * b) + i} <- kept
  done;
  let kept = numbers.(a) in
  numbers.(a) <- numbers.(b);
  numbers.(b) <- kept

let partition leaves goes_first first stop =
  let rec loop low high =
    if low >= high then low
    else if goes_first low then loop (low + 1) high
    else (
      swap leaves low (high - 1);
      loop low (high - 1))
  in
  loop first stop

let numbers leaves = leaves.numbers

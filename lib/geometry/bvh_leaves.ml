open Bigarray

type boxes = (float, float64_elt, c_layout) Array1.t
type kind = Sphere | Other
type t = { boxes : boxes; numbers : int array; shapes : Shape.t array }

let of_shapes shapes =
  let count_bounded count shape =
    if Option.is_some (Shape.box shape) then count + 1 else count
  in
  let count = Array.fold_left count_bounded 0 shapes in
  let leaves =
    {
      boxes = Array1.create Float64 C_layout (6 * count);
      numbers = Array.make count 0;
      shapes;
    }
  and place = ref 0 in
  let add number { Box3.low; high } =
    let at = 6 * !place in
    leaves.boxes.{at} <- low.x;
    leaves.boxes.{at + 1} <- high.x;
    leaves.boxes.{at + 2} <- low.y;
    leaves.boxes.{at + 3} <- high.y;
    leaves.boxes.{at + 4} <- low.z;
    leaves.boxes.{at + 5} <- high.z;
    leaves.numbers.(!place) <- number;
    incr place
  in
  Array.iteri (fun number s -> Option.iter (add number) (Shape.box s)) shapes;
  leaves

let count { numbers; _ } = Array.length numbers

let[@inline] side { boxes; _ } place side =
  Array1.unsafe_get boxes ((6 * place) + side)

let[@inline] centre leaves place axis =
  (0.5 *. side leaves place (2 * axis))
  +. (0.5 *. side leaves place ((2 * axis) + 1))

let kind { numbers; shapes; _ } place =
  match shapes.(numbers.(place)) with Shape.Sphere _ -> Sphere | _ -> Other

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

let spheres { numbers; shapes; _ } =
  let is_sphere = function Shape.Sphere _ -> true | _ -> false in
  let rows =
    if Array.exists is_sphere shapes then Array.length numbers else 0
  in
  let spheres = Array.make (4 * rows) 0. in
  let write place number =
    match shapes.(number) with
    | Shape.Sphere { cx; cy; cz; radius } ->
        let at = 4 * place in
        spheres.(at) <- cx;
        spheres.(at + 1) <- cy;
        spheres.(at + 2) <- cz;
        spheres.(at + 3) <- radius
    | _ -> ()
  in
  Array.iteri write numbers;
  spheres

let numbers leaves = leaves.numbers

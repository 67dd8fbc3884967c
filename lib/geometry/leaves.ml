open Unchecked

type t = {
  numbers : int array;
  balls : float array;
  boxes : float array;
  shapes : Shape.t array;
  extent : float;
}

let is_sphere = function Shape.Sphere _ -> true | _ -> false

let sides shape =
  match Shape.box shape with
  | None -> invalid_arg "a leaf without a box"
  | Some { Box3.low; high } ->
      [| low.x; high.x; low.y; high.y; low.z; high.z |]

let make shapes ~numbers ~balls =
  let count = Array.length numbers in
  let shape place = shapes.(numbers.(place)) in
  let all_balls =
    Array.for_all (fun number -> is_sphere shapes.(number)) numbers
  in
  let balls = if balls = [||] then Array.make (4 * count) 0. else balls
  and boxes = if all_balls then [||] else Array.make (6 * count) 0.
  and extent = ref 0. in
  let reach x = if not (abs_float x <= !extent) then extent := abs_float x in
  for place = 0 to count - 1 do
    match shape place with
    | Sphere { cx; cy; cz; radius } ->
        reach (abs_float cx +. radius);
        reach (abs_float cy +. radius);
        reach (abs_float cz +. radius)
    | other ->
        let sides = sides other in
        Array.blit sides 0 boxes (6 * place) 6;
        Array.iter reach sides
  done;
  { numbers; balls; boxes; shapes; extent = !extent }

let count { numbers; _ } = Array.length numbers
let[@inline] is_ball { balls; _ } place = balls.%((4 * place) + 3) > 0.

let[@inline never] offer_other { numbers; shapes; _ } place ray meeting =
  let number = numbers.(place) in
  Shape.offer shapes.(number) ray meeting ~number

let[@inline always] offer leaves place ray meeting =
  if is_ball leaves place then
    let number = Array.unsafe_get leaves.numbers place in
    Sphere.offer_row leaves.balls place ray meeting ~number
  else offer_other leaves place ray meeting

open Numbers

type t = { spheres : float array; numbers : int array; shapes : Shape.t array }

let of_shapes ~quick shapes =
  let count = ref 0 and others = ref false in
  let count_bounded = function
    | Shape.Sphere _ when quick -> incr count
    | shape ->
        if Option.is_some (Shape.ball shape) then (
          incr count;
          others := true)
  in
  Array.iter count_bounded shapes;
  let spheres = Array.make (4 * !count) 0.
  and numbers = Array.make !count 0
  and place = ref 0 in
  let add number { Sphere.cx; cy; cz; radius } =
    let at = 4 * !place in
    spheres.(at) <- cx;
    spheres.(at + 1) <- cy;
    spheres.(at + 2) <- cz;
    spheres.(at + 3) <- radius;
    numbers.(!place) <- number;
    incr place
  in
  Array.iteri (fun number s -> Option.iter (add number) (Shape.ball s)) shapes;
  { spheres; numbers; shapes = (if !others then shapes else [||]) }

let mark_others ~quick { spheres; numbers; shapes } =
  let mark place number =
    match shapes.(number) with
    | Shape.Sphere _ when quick -> ()
    | _ -> spheres.((4 * place) + 3) <- infinity
  in
  if Array.length shapes > 0 then Array.iteri mark numbers

let[@inline] other_distance { numbers; shapes; _ } place ray =
  Shape.nearest_raw shapes.(numbers.(place)) ray

let count { numbers; _ } = Array.length numbers
let[@inline] centre { spheres; _ } place axis = spheres.%((4 * place) + axis)
let[@inline] radius { spheres; _ } place = spheres.%((4 * place) + 3)

let swap { spheres; numbers; _ } a b =
  for i = 0 to 3 do
    let kept = spheres.((4 * a) + i) in
    spheres.((4 * a) + i) <- spheres.((4 * b) + i);
    spheres.((4 * b) + i) <- kept
  done;
  let kept = numbers.(a) in
  numbers.(a) <- numbers.(b);
  numbers.(b) <- kept

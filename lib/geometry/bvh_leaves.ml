open Numbers

type t = { spheres : float array; numbers : int array }

let of_shapes shapes =
  let is_sphere = function Shape.Sphere _ -> true | Plane _ -> false in
  let count_sphere n shape = if is_sphere shape then n + 1 else n in
  let count = Array.fold_left count_sphere 0 shapes in
  let spheres = Array.make (4 * count) 0. and numbers = Array.make count 0 in
  let place = ref 0 in
  let add number { Sphere.cx; cy; cz; radius } =
    let at = 4 * !place in
    spheres.(at) <- cx;
    spheres.(at + 1) <- cy;
    spheres.(at + 2) <- cz;
    spheres.(at + 3) <- radius;
    numbers.(!place) <- number;
    incr place
  in
  Array.iteri
    (fun number -> function Shape.Sphere s -> add number s | Plane _ -> ())
    shapes;
  { spheres; numbers }

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

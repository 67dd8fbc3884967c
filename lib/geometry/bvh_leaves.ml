open Numbers

type t = { spheres : float array; numbers : int array }

let of_array numbered =
  let numbers_of (_, (s : Sphere.t)) = [| s.cx; s.cy; s.cz; s.radius |] in
  let spheres = Array.make (4 * Array.length numbered) 0. in
  Array.iteri
    (fun place sphere -> Array.blit (numbers_of sphere) 0 spheres (4 * place) 4)
    numbered;
  { spheres; numbers = Array.map fst numbered }

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

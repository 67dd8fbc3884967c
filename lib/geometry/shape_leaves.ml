let of_shapes shapes =
  let kinds number : Bvh_leaves.kind =
    match shapes.(number) with Shape.Sphere _ -> Sphere | _ -> Other
  and count_boxed count shape =
    if Option.is_some (Shape.box shape) then count + 1 else count
  in
  let leaves = Bvh_leaves.create ~kinds (Array.fold_left count_boxed 0 shapes)
  and place = ref 0 in
  let add number { Box3.low; high } =
    let set side x = Bvh_leaves.set_side leaves !place side x in
    set 0 low.x;
    set 1 high.x;
    set 2 low.y;
    set 3 high.y;
    set 4 low.z;
    set 5 high.z;
    Bvh_leaves.set_number leaves !place number;
    incr place
  in
  Array.iteri (fun number s -> Option.iter (add number) (Shape.box s)) shapes;
  leaves

let spheres shapes numbers =
  let is_sphere = function Shape.Sphere _ -> true | _ -> false in
  let count =
    if Array.exists is_sphere shapes then Array.length numbers else 0
  in
  let rows = Array.make (4 * count) 0. in
  let write place number =
    match shapes.(number) with
    | Shape.Sphere { cx; cy; cz; radius } ->
        let at = 4 * place in
        rows.(at) <- cx;
        rows.(at + 1) <- cy;
        rows.(at + 2) <- cz;
        rows.(at + 3) <- radius
    | _ -> ()
  in
  Array.iteri write numbers;
  rows

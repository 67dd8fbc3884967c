open Raylab_geometry.Unchecked

type t = { size : int; mutable numbers : float array; mutable count : int }

let create ~colors = { size = 1 + (3 * colors); numbers = [||]; count = 0 }
let clear parts = parts.count <- 0

let reserve parts count =
  let needed = count * parts.size and room = Array.length parts.numbers in
  if needed > room then (
    let numbers = Array.make (Int.max needed (2 * room)) 0. in
    Array.blit parts.numbers 0 numbers 0 room;
    parts.numbers <- numbers)

let add parts key =
  let at = parts.count * parts.size in
  reserve parts (parts.count + 1);
  Array.fill parts.numbers at parts.size 0.;
  parts.numbers.(at) <- key;
  parts.count <- parts.count + 1;
  at

let set { numbers; _ } at ({ r; g; b } : Color.t) =
  numbers.(at) <- r;
  numbers.(at + 1) <- g;
  numbers.(at + 2) <- b

let scale { numbers; size; _ } part ({ r; g; b } : Color.t) =
  let at = ref ((part * size) + 1) in
  while !at < (part + 1) * size do
    numbers.(!at) <- Saturate.limit (r *. numbers.%(!at));
    numbers.(!at + 1) <- Saturate.limit (g *. numbers.%(!at + 1));
    numbers.(!at + 2) <- Saturate.limit (b *. numbers.%(!at + 2));
    at := !at + 3
  done

let rec of_key ({ numbers; size; _ } as parts) key ~first ~stop =
  if first = stop || numbers.%(first * size) = numbers.%(key) then first
  else of_key parts key ~first:(first + 1) ~stop

let add_to { numbers; size; _ } part other =
  for k = 1 to size - 1 do
    let at = (part * size) + k in
    numbers.(at) <-
      Saturate.limit (numbers.%(at) +. numbers.%((other * size) + k))
  done

let mix ({ size; _ } as parts) ~first ~from weight =
  let count = parts.count in
  parts.count <- from;
  for other = from to count - 1 do
    scale parts other weight;
    let part = of_key parts (other * size) ~first ~stop:parts.count in
    if part < parts.count then add_to parts part other
    else (
      Array.blit parts.numbers (other * size) parts.numbers (part * size) size;
      parts.count <- part + 1)
  done

module Ints = struct
  type t = { mutable items : int array; mutable length : int }

  let create () = { items = [||]; length = 0 }
  let length t = t.length
  let clear t = t.length <- 0

  let get t k =
    if k >= t.length then invalid_arg "Growing.Ints.get";
    t.items.(k)

  let add t i =
    if t.length = Array.length t.items then
      t.items <- Array.append t.items (Array.make (16 + t.length) 0);
    t.items.(t.length) <- i;
    t.length <- t.length + 1

  let to_array t = Array.sub t.items 0 t.length
end

module Floats = struct
  type t = { mutable items : float array; mutable length : int }

  let create () = { items = [||]; length = 0 }
  let length t = t.length

  let get t k =
    if k >= t.length then invalid_arg "Growing.Floats.get";
    t.items.(k)

  let[@inline] add t x =
    if t.length = Array.length t.items then
      t.items <- Array.append t.items (Array.make (16 + t.length) 0.);
    t.items.(t.length) <- x;
    t.length <- t.length + 1

  let to_array t = Array.sub t.items 0 t.length
end

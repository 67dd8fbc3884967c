let[@inline] mul_add a b c =
  let product = a *. b in
  product +. c

let[@inline] sub_mul c a b =
  let product = a *. b in
  c -. product

(* 2^27 + 1: the product has the upper half twice, 27 bits apart. *)
let[@inline] head x =
  let apart = 134217729. *. x in
  apart -. (apart -. x)

(* 1.5 * 2^52, where doubles are the whole numbers. *)
let[@inline] nearest x = x +. 6755399441055744. -. 6755399441055744.
let lowest = -1074
let highest = 1023

let powers =
  let powers = Array.make (highest - lowest + 1) 1. in
  for e = 1 to highest do
    powers.(e - lowest) <- 2. *. powers.(e - 1 - lowest)
  done;
  for e = -1 downto lowest do
    powers.(e - lowest) <- 0.5 *. powers.(e + 1 - lowest)
  done;
  powers

let[@inline] power e = powers.(e - lowest)

(* By halves, since a power may have no double where the result has. *)
let[@inline] scale x e =
  let half = e asr 1 in
  x *. power half *. power (e - half)

let[@inline] exponent x =
  (* Most numbers are everyday ones, for which this is half the way. *)
  let everyday = x >= power (-16) && x < power 16 in
  let low = ref (if everyday then -16 else lowest)
  and high = ref (if everyday then 16 else highest + 1) in
  while !high - !low > 1 do
    let middle = (!low + !high) asr 1 in
    if x < power middle then high := middle else low := middle
  done;
  !low

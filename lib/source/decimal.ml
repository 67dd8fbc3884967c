(* 10^0 to 10^22, all of which are doubles. *)
let powers = Array.init 23 (fun k -> float_of_string (Printf.sprintf "1e%d" k))

(* All integers of this many digits are doubles, and ints: those of JavaScript
   have 32 bits. *)
let exact_digits = if Sys.int_size > 32 then 15 else 9

(* Reads digits, of which at most [exact_digits] may be significant. *)
let of_bytes text ~first ~stop =
  let slow () = float_of_string (Bytes.sub_string text first (stop - first)) in
  let negative = Bytes.get text first = '-' in
  let rec digits at mantissa count decimals seen_point =
    if at = stop then
      if decimals >= Array.length powers then slow ()
      else
        let magnitude = float_of_int mantissa /. powers.(decimals) in
        if negative then -.magnitude else magnitude
    else
      match Bytes.unsafe_get text at with
      | '0' .. '9' as c ->
          if count = exact_digits then slow ()
          else
            let mantissa = (10 * mantissa) + Char.code c - Char.code '0' in
            digits (at + 1) mantissa
              (if mantissa = 0 then 0 else count + 1)
              (if seen_point then decimals + 1 else decimals)
              seen_point
      | '.' -> digits (at + 1) mantissa count decimals true
      | ('+' | '-') when at = first ->
          digits (at + 1) mantissa count decimals seen_point
      | _ -> slow () (* an exponent *)
  in
  digits first 0 0 0 false

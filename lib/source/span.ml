type t = int

let length_bits = 31
let longest = (1 lsl length_bits) - 1

let make ~start ~stop =
  (start lsl length_bits) lor Int.min longest (Int.max 0 (stop - start))

let start span = span lsr length_bits
let stop span = start span + (span land longest)

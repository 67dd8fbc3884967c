let unless_nan show x = if Float.is_nan x then "-" else show x
let decimals n = unless_nan (Printf.sprintf "%.*f" n)
let ratio = decimals 2

let milliseconds =
  unless_nan (fun s ->
      let ms = 1000. *. s in
      Printf.sprintf "%.*f" (if ms < 10. then 1 else 0) ms)

let count n =
  let digits = string_of_int n in
  let length = String.length digits in
  String.concat ""
    (List.init length (fun k ->
         let comma = k > 0 && (length - k) mod 3 = 0 in
         (if comma then "," else "") ^ String.make 1 digits.[k]))

let megabytes = unless_nan (fun b -> Printf.sprintf "%.1f" (b /. 1e6))

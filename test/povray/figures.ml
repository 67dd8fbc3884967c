let minimum = function
  | [] -> Float.nan
  | x :: xs -> List.fold_left Float.min x xs

let median xs =
  let sorted = Array.of_list (List.sort Float.compare xs) in
  let n = Array.length sorted in
  if n = 0 then Float.nan else (sorted.((n - 1) / 2) +. sorted.(n / 2)) /. 2.

let worst is_worse named =
  let pick found (name, x) =
    match found with
    | _ when Float.is_nan x -> found
    | Some (_, y) when not (is_worse x y) -> found
    | _ -> Some (name, x)
  in
  List.fold_left pick None named

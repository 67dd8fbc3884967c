type rule = Finite | Non_negative | Positive

let broken rule x =
  if not (Float.is_finite x) then Some "must be a finite number"
  else
    match rule with
    | Finite -> None
    | Non_negative -> if x >= 0. then None else Some "must not be negative"
    | Positive -> if x > 0. then None else Some "must be greater than 0"

let require rule name x =
  match broken rule x with
  | None -> ()
  | Some problem -> invalid_arg (Printf.sprintf "%s (%g) %s" name x problem)

let pp ppf x =
  (* adding 0 turns -0 into 0 *)
  Format.fprintf ppf "%.6g" (x +. 0.)

let to_exact_string x =
  let reads_back digits =
    let text = Printf.sprintf "%.*g" digits x in
    if Float.equal (float_of_string text) x then Some text else None
  in
  match List.find_map reads_back [ 6; 15; 16 ] with
  | Some text -> text
  | None -> Printf.sprintf "%.17g" x

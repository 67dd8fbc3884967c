let most = 6

let list items =
  let shown =
    if List.compare_length_with items most <= 0 then items
    else
      let hidden = List.length items - most + 1 in
      List.filteri (fun i _ -> i < most - 1) items
      @ [ string_of_int hidden ^ " more" ]
  in
  match List.rev shown with
  | last :: (_ :: _ as before) ->
      String.concat ", " (List.rev before) ^ " and " ^ last
  | _ -> String.concat "" shown

let lights = function
  | [ number ] -> Printf.sprintf "light %d" number
  | numbers -> "lights " ^ list (List.map string_of_int numbers)

let number = Printf.sprintf "%.3g"
let percent x = number (Float.min max_float (100. *. x)) ^ " %"

let rough_percent x =
  let x = Float.min max_float (100. *. x) in
  Printf.sprintf
    (if x < 10. then "%.2g %%" else if x < 1000. then "%.0f %%" else "%.3g %%")
    x

(* Eight, eleven, eighteen, eighty ... *)
let starts_with_vowel phrase =
  match phrase.[0] with
  | 'a' | 'e' | 'i' | 'o' | 'u' | '8' -> true
  | _ ->
      List.exists
        (fun n -> String.starts_with ~prefix:n phrase)
        [ "11 "; "18 " ]

let a phrase = (if starts_with_vowel phrase then "an " else "a ") ^ phrase

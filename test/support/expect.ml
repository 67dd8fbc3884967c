let invalid what f =
  match f () with
  | _ -> Alcotest.failf "%s: no Invalid_argument" what
  | exception Invalid_argument _ -> ()

let occurs ~part text =
  let n = String.length part in
  let rec look i =
    i + n <= String.length text && (String.sub text i n = part || look (i + 1))
  in
  look 0

let contains what ~part text =
  if not (occurs ~part text) then
    Alcotest.failf "%s: no '%s' in '%s'" what part text

let prints what expected pp value =
  Alcotest.(check string) what expected (Format.asprintf "%a" pp value)

type t = {
  mutable steps : int;
  mutable made : int;
  mutable depth : int;
  most_steps : int;
  most_made : int;
}

let scene_steps = 100_000_000
let pattern_steps = 100_000
let most_made = 20_000_000
let most_calls = 1_000

let limited ~steps ~made =
  { steps = 0; made = 0; depth = 0; most_steps = steps; most_made = made }

let start ~steps = limited ~steps ~made:most_made
let scene () = start ~steps:scene_steps

let grouped n =
  let digits = string_of_int n in
  let length = String.length digits in
  let piece k c =
    if k > 0 && (length - k) mod 3 = 0 then Printf.sprintf ",%c" c
    else String.make 1 c
  in
  String.concat "" (List.mapi piece (List.of_seq (String.to_seq digits)))

let exceeded span what =
  Fault.stop span what
    ~advice:"a scene must come to an end: make its loops and calls fewer"

let no_more_steps budget span =
  exceeded span
    (Printf.sprintf "the evaluation takes more than %s steps"
       (grouped budget.most_steps))

let step budget span =
  let steps = budget.steps + 1 in
  budget.steps <- steps;
  if steps > budget.most_steps then no_more_steps budget span

let steps budget span count =
  (* one too many is enough, and no sum of two counts overflows *)
  let steps = budget.steps + Int.min count (budget.most_steps + 1) in
  budget.steps <- steps;
  if steps > budget.most_steps then no_more_steps budget span

let make budget span count =
  let made = budget.made + Int.min count (budget.most_made + 1) in
  budget.made <- made;
  if made > budget.most_made then
    exceeded span
      (Printf.sprintf "more than %s objects and elements of lists are computed"
         (grouped budget.most_made))

let enter budget span =
  let depth = budget.depth + 1 in
  budget.depth <- depth;
  if depth > most_calls then
    exceeded span
      (Printf.sprintf "more than %s calls are nested" (grouped most_calls))

let leave budget = budget.depth <- budget.depth - 1

let restart budget =
  budget.steps <- 0;
  budget.made <- 0;
  budget.depth <- 0

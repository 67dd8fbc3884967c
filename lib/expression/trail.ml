type t =
  | Start
  | Call of {
      name : string;
      arguments : (string * Datum.t) list;
      at : int;
      around : t;
    }
  | Round of { loop : loop; value : Datum.t; around : t }

and loop = { name : string; at : int }

let around = function
  | Start -> Start
  | Call { around; _ } | Round { around; _ } -> around

let length trail =
  let rec add n = function
    | Start -> n
    | trail -> add (n + 1) (around trail)
  in
  add 0 trail

let rec outwards trail levels =
  if levels <= 0 then trail else outwards (around trail) (levels - 1)

let apart trail ~from =
  let n = length trail and m = length from in
  let rec collect found trail from =
    if trail == from then List.rev found
    else collect (trail :: found) (around trail) (around from)
  in
  let rec inner found trail levels =
    if levels <= 0 then collect found trail (outwards from (m - n))
    else inner (trail :: found) (around trail) (levels - 1)
  in
  inner [] trail (n - m)

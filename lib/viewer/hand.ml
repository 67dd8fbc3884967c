type place = int * int
type t = Free | Held of { from : place; drags : bool }

let free = Free
let is_free hand = hand = Free

type gesture =
  | Nothing
  | Click of place
  | Drag of { across : int; down : int }

let threshold = 4
let press from = Held { from; drags = false }

let move (x, y) = function
  | Free -> (Free, Nothing)
  | Held { from = (u, v) as from; drags } ->
      let across = x - u and down = y - v in
      if drags || Int.max (abs across) (abs down) >= threshold then
        (Held { from; drags = true }, Drag { across; down })
      else (Held { from; drags }, Nothing)

let release place hand =
  match (move place hand, hand) with
  | (_, (Drag _ as drag)), _ -> drag
  | _, Held { from; _ } -> Click from
  | _, Free -> Nothing

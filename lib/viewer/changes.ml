type 'stamp t = {
  told : 'stamp option;
  last : 'stamp option;
  since : float; (* when [last] was first seen *)
}

let settling = 0.05
let patience = 1.
let initial stamp = { told = stamp; last = stamp; since = neg_infinity }

let step ~now stamp state =
  let state =
    if stamp = state.last then state
    else { state with last = stamp; since = now }
  in
  let enough = if stamp = None then patience else settling in
  if stamp <> state.told && now -. state.since >= enough then
    ({ state with told = stamp }, true)
  else (state, false)

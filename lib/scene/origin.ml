type t = Unknown | Literal of int

let offset = function Unknown -> None | Literal at -> Some at

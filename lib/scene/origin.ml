type t = Unknown | Literal of int

type t = { start : int; stop : int }

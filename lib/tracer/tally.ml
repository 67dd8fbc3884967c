type t = {
  mutable primary : int;
  mutable reflected : int;
  mutable shadow : int;
  mutable hits : int;
  mutable blocked : int;
}

let create () =
  { primary = 0; reflected = 0; shadow = 0; hits = 0; blocked = 0 }

let rays tally = tally.primary + tally.reflected + tally.shadow

let add a b =
  {
    primary = a.primary + b.primary;
    reflected = a.reflected + b.reflected;
    shadow = a.shadow + b.shadow;
    hits = a.hits + b.hits;
    blocked = a.blocked + b.blocked;
  }

let sum tallies = List.fold_left add (create ()) tallies

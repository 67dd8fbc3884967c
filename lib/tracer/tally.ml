type t = {
  mutable primary : int;
  mutable reflected : int;
  mutable refracted : int;
  mutable shadow : int;
  mutable hits : int;
  mutable blocked : int;
  mutable samples : int;
  mutable over_exposed : int;
}

let create () =
  {
    primary = 0;
    reflected = 0;
    refracted = 0;
    shadow = 0;
    hits = 0;
    blocked = 0;
    samples = 0;
    over_exposed = 0;
  }

let rays tally =
  tally.primary + tally.reflected + tally.refracted + tally.shadow

let add a b =
  {
    primary = a.primary + b.primary;
    reflected = a.reflected + b.reflected;
    refracted = a.refracted + b.refracted;
    shadow = a.shadow + b.shadow;
    hits = a.hits + b.hits;
    blocked = a.blocked + b.blocked;
    samples = a.samples + b.samples;
    over_exposed = a.over_exposed + b.over_exposed;
  }

let sum tallies = List.fold_left add (create ()) tallies

type t = {
  own : Crossings.t;
  all : Crossings.t;
  mutable members : int array;
  mutable enters : bool array;
  mutable order : int array;
  mutable at : int;
  mutable counts : int array;
  mutable before : int array;
  mutable moved : int array;
}

let create () =
  {
    own = Crossings.create ();
    all = Crossings.create ();
    members = [||];
    enters = [||];
    order = [||];
    at = 0;
    counts = [||];
    before = [||];
    moved = [||];
  }

let reset room ~gates ~members =
  Crossings.clear room.all ~starts_inside:false;
  room.at <- 0;
  if Array.length room.counts < gates then (
    room.counts <- Array.make gates 0;
    room.before <- Array.make gates 0)
  else Array.fill room.counts 0 gates 0;
  if Array.length room.moved < members then room.moved <- Array.make members 0

(* At least twice as long. *)
let wider old least fill =
  let more = Int.max least (Array.length old) in
  Array.append old (Array.make more fill)

let add_own room ~member ~members =
  let { own; all; _ } = room in
  let count = all.count + own.count in
  if Array.length room.members < count then (
    room.members <- wider room.members count 0;
    room.enters <- wider room.enters count false;
    room.order <- wider room.order count 0);
  for k = 0 to own.count - 1 do
    let at = all.count in
    Crossings.add all
      ~part:((own.parts.(k) * members) + member)
      own.distances.(k);
    room.members.(at) <- member;
    room.enters.(at) <- Crossings.enters own k;
    room.order.(at) <- at
  done

let[@inline] comes_after (distances : float array) a b =
  distances.(a) > distances.(b) || (distances.(a) = distances.(b) && a > b)

(* By D. Shell's method, in place, with gaps of 3 k + 1: there are few of them,
   in runs that are sorted. *)
let sort { order; all = { count; distances; _ }; _ } =
  let gap = ref 1 in
  while !gap < count / 3 do
    gap := (3 * !gap) + 1
  done;
  while !gap > 0 do
    for k = !gap to count - 1 do
      let moved = order.(k) and at = ref k in
      while !at >= !gap && comes_after distances order.(!at - !gap) moved do
        order.(!at) <- order.(!at - !gap);
        at := !at - !gap
      done;
      order.(!at) <- moved
    done;
    gap := !gap / 3
  done

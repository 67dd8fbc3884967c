type t = {
  mutable count : int;
  mutable starts_inside : bool;
  mutable distances : float array;
  mutable parts : int array;
  mesh : Mesh_scratch.t;
}

let create () =
  {
    count = 0;
    starts_inside = false;
    distances = Array.make 8 0.;
    parts = Array.make 8 0;
    mesh = Mesh_scratch.create ();
  }

let clear crossings ~starts_inside =
  crossings.count <- 0;
  crossings.starts_inside <- starts_inside

let grow crossings =
  let wider old fill = Array.append old (Array.make (Array.length old) fill) in
  crossings.distances <- wider crossings.distances 0.;
  crossings.parts <- wider crossings.parts 0

let[@inline] add crossings ~part t =
  let at = crossings.count in
  if at = Array.length crossings.distances then grow crossings;
  crossings.distances.(at) <- t;
  crossings.parts.(at) <- part;
  crossings.count <- at + 1

let divide { count; distances; _ } length =
  for k = 0 to count - 1 do
    distances.(k) <- distances.(k) /. length
  done

let insert crossings ~part t =
  add crossings ~part t;
  let { distances; parts; _ } = crossings in
  let at = ref (crossings.count - 1) in
  while
    !at > 0
    && (distances.(!at - 1) > t
       || (distances.(!at - 1) = t && parts.(!at - 1) > part))
  do
    distances.(!at) <- distances.(!at - 1);
    parts.(!at) <- parts.(!at - 1);
    decr at
  done;
  distances.(!at) <- t;
  parts.(!at) <- part

let enters crossings k = k land 1 = 0 <> crossings.starts_inside

type crossing = { t : float; part : int; enters : bool }

let to_list crossings =
  List.init crossings.count (fun k ->
      {
        t = crossings.distances.(k);
        part = crossings.parts.(k);
        enters = enters crossings k;
      })

type operation = Union | Intersection | Difference

type 'member tree =
  | Member of 'member
  | Combined of operation * 'member tree list

type 'shape t = {
  tree : int tree;
  members : 'shape array;
  flipped : bool array;
  gates : Gates.t;
  tolerance : float;
}

let word = function
  | Union -> "union"
  | Intersection -> "intersection"
  | Difference -> "difference"

(* {1 Making them} *)

let rec numbered next = function
  | Member shape -> (next + 1, Member next, [ shape ])
  | Combined (operation, parts) ->
      let add (next, parts, shapes) part =
        let next, part, more = numbered next part in
        (next, part :: parts, more :: shapes)
      in
      let next, parts, shapes = List.fold_left add (next, [], []) parts in
      ( next,
        Combined (operation, List.rev parts),
        List.concat (List.rev shapes) )

let require_parts operation = function
  | [] -> invalid_arg (word operation ^ " of nothing")
  | _ :: _ -> ()

let rec gate : int tree -> Gates.shape = function
  | Member m -> Member m
  | Combined (operation, parts) ->
      let gates = List.map gate parts in
      let all weight = List.map (fun gate -> (weight, gate)) in
      let need, parts =
        match (operation, gates) with
        | Union, gates -> (1, all 1 gates)
        | Intersection, gates -> (List.length gates, all 1 gates)
        | Difference, first :: others -> (1, (1, first) :: all (-1) others)
        | Difference, [] -> (1, [])
      in
      if operation <> Union then require_parts operation parts;
      Gate { need; parts }

let make tree =
  let tree =
    match tree with Member _ -> Combined (Union, [ tree ]) | tree -> tree
  in
  let count, tree, shapes = numbered 0 tree in
  let gates = Gates.make ~members:count (gate tree) in
  {
    tree;
    members = Array.of_list shapes;
    flipped = Gates.flipped gates;
    gates;
    tolerance = 0.;
  }

let with_members members solid = { solid with members }
let map f solid = { solid with members = Array.map f solid.members }
let with_tolerance tolerance solid = { solid with tolerance }

let operation { tree; _ } =
  match tree with Combined (operation, _) -> operation | Member _ -> Union

let rec map_tree f = function
  | Member m -> Member (f m)
  | Combined (operation, parts) ->
      Combined (operation, List.map (map_tree f) parts)

let to_tree { tree; members; _ } = map_tree (fun m -> members.(m)) tree

(* {1 Parts} *)

let member_of { members; _ } ~part = part mod Array.length members
let own_part { members; _ } ~part = part / Array.length members

(* {1 What is hit} *)

(* Brings the crossings of all members into the room. *)
let gather own_crossings { members; gates; _ } ray (room : Scratch.t) =
  let count = Array.length members in
  Scratch.reset room ~gates:(Gates.count gates) ~members:count;
  for member = 0 to count - 1 do
    own_crossings members.(member) ray room.own;
    if room.own.starts_inside then
      Gates.pass gates room.counts ~member ~enters:true;
    Scratch.add_own room ~member ~members:count
  done;
  Scratch.sort room

(* How near together faces coincide where the ray has come to [t]: as for the
   offset of rays that start there. *)
let[@inline] near { tolerance; _ } (ray : Raw_ray.t) t =
  let { Raw_ray.ox; oy; oz; dx; dy; dz; _ } = ray in
  let least =
    Offset.rounding
    *. (abs_float ox +. abs_float oy +. abs_float oz
       +. abs_float (ox +. (t *. dx))
       +. abs_float (oy +. (t *. dy))
       +. abs_float (oz +. (t *. dz)))
  in
  if tolerance >= least then tolerance else least

let pass { gates; _ } (room : Scratch.t) =
  let crossing = room.order.(room.at) in
  let member = room.members.(crossing) and enters = room.enters.(crossing) in
  Gates.pass gates room.counts ~member ~enters;
  room.moved.(member) <- (if enters then 1 else -1);
  room.at <- room.at + 1

(* Whether the next crossing is within [most], and of a member that has not been
   crossed yet: what is thin stays as thin as it is. *)
let[@inline] goes_with (room : Scratch.t) most =
  room.at < room.all.count
  &&
  let crossing = room.order.(room.at) in
  room.all.distances.(crossing) <= most
  && room.moved.(room.members.(crossing)) = 0

(* Passes the next crossing and all that coincide with it. *)
let pass_all solid ray (room : Scratch.t) =
  let start = room.all.distances.(room.order.(room.at)) in
  let most = start +. near solid ray start in
  pass solid room;
  while goes_with room most do
    pass solid room
  done

(* Of the crossings passed since [first] that of this member; all moves are
   forgotten. *)
let crossing_of (room : Scratch.t) ~first member =
  let found = ref room.order.(first) in
  for k = first to room.at - 1 do
    let crossing = room.order.(k) in
    let passed = room.members.(crossing) in
    if passed = member then found := crossing;
    room.moved.(passed) <- 0
  done;
  !found

let none = -1

(* The next crossing of the solid itself, by its place among all. *)
let rec next ({ gates; _ } as solid) ray (room : Scratch.t) =
  if room.at >= room.all.count then none
  else
    let first = room.at and was_inside = Gates.is_up gates room.counts in
    Array.blit room.counts 0 room.before 0 (Gates.count gates);
    pass_all solid ray room;
    let changes = Gates.is_up gates room.counts <> was_inside in
    let member =
      if not (changes && room.at > first + 1) then none
      else
        Gates.standing gates ~before:room.before ~after:room.counts
          ~moved:room.moved
    in
    let crossing = crossing_of room ~first member in
    if changes then crossing else next solid ray room

let rec next_in_front solid ray (room : Scratch.t) =
  let crossing = next solid ray room in
  if crossing <> none && room.all.distances.(crossing) <= 0. then
    next_in_front solid ray room
  else crossing

let offer own_crossings solid (ray : Raw_ray.t) (meeting : Meeting.t) ~number =
  let room = meeting.scratch in
  gather own_crossings solid ray room;
  let crossing = next_in_front solid ray room in
  if crossing <> none then
    Meeting.offer meeting ray ~number ~part:room.all.parts.(crossing)
      room.all.distances.(crossing)

let settle own_settle ({ members; flipped; _ } as solid) ~part ray spot =
  let member = member_of solid ~part in
  own_settle members.(member) ~part:(own_part solid ~part) ray spot;
  if flipped.(member) then
    Spot.set_normal spot (-.spot.nx) (-.spot.ny) (-.spot.nz)

let crossings own_crossings ({ gates; _ } as solid) ray found =
  let room = Scratch.create () in
  gather own_crossings solid ray room;
  Crossings.clear found ~starts_inside:(Gates.is_up gates room.counts);
  let rec add_all () =
    let crossing = next solid ray room in
    if crossing <> none then (
      Crossings.add found ~part:room.all.parts.(crossing)
        room.all.distances.(crossing);
      add_all ())
  in
  add_all ()

(* {1 Where it is} *)

type extent = Empty | Within of Box3.t | Endless

let around a b =
  match (a, b) with
  | Empty, other | other, Empty -> other
  | Endless, _ | _, Endless -> Endless
  | Within a, Within b -> Within (Box3.union a b)

let common a b =
  match (a, b) with
  | Empty, _ | _, Empty -> Empty
  | Endless, other | other, Endless -> other
  | Within a, Within b ->
      Option.fold ~none:Empty
        ~some:(fun box -> Within box)
        (Box3.intersection a b)

let rec fold member combined = function
  | Member m -> member m
  | Combined (operation, parts) ->
      combined operation (List.map (fold member combined) parts)

let box own_box { tree; members; tolerance; _ } =
  let member m =
    Option.fold ~none:Endless
      ~some:(fun box -> Within box)
      (own_box members.(m))
  and combined operation extents =
    match operation with
    | Union -> List.fold_left around Empty extents
    | Intersection -> List.fold_left common Endless extents
    | Difference -> List.hd extents
  in
  match fold member combined tree with
  | Endless -> None
  | Within box -> Some (Box3.wider tolerance box)
  | Empty -> Some (Box3.make ~low:Vec3.zero ~high:Vec3.zero)

let depth own_depth { tree; members; _ } point =
  let least = List.fold_left Float.min infinity
  and most = List.fold_left Float.max neg_infinity in
  let member m = own_depth members.(m) point
  and combined operation depths =
    match operation with
    | Union -> most depths
    | Intersection -> least depths
    | Difference ->
        least (List.hd depths :: List.map Float.neg (List.tl depths))
  in
  fold member combined tree

let number = function Union -> 0. | Intersection -> 1. | Difference -> 2.

(* Each grouping, and how many parts it has. *)
let numbers { tree; _ } =
  let member _ = [ -1. ]
  and combined operation parts =
    number operation :: float_of_int (List.length parts) :: List.concat parts
  in
  Array.of_list (fold member combined tree)

let pp_with pp_member ppf { tree; members; _ } =
  let rec print ppf = function
    | Member m -> pp_member ppf members.(m)
    | Combined (operation, parts) ->
        let pp_sep ppf () = Format.fprintf ppf ", " in
        Format.fprintf ppf "%s %a end" (word operation)
          (Format.pp_print_list ~pp_sep print)
          parts
  in
  print ppf tree

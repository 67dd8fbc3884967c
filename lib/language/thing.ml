open Raylab_geometry
open Raylab_expression
open Raylab_scene

type t = Surface of Surface.t | Light of placeable | Object of placeable
and placeable = { node : node; born : int }

and node =
  | Leaf of Object.t
  | Lamp of Light.t
  | Many of { nodes : node list; size : size }
  | Changed of { change : Change.t; node : node; size : size }
  | Named of { named : named; node : node; size : size }

and size = { count : int; visits : int }
and named = { name : string; at : int; within : Trail.t }

let one = { count = 1; visits = 1 }

let size = function
  | Leaf _ | Lamp _ -> one
  | Many { size; _ } | Changed { size; _ } | Named { size; _ } -> size

(* Groups of groups double what they have, also if that is nothing. *)
let most_visits = 1_000_000_000

let sum a b =
  {
    count = a.count + b.count;
    visits = Int.min most_visits (a.visits + b.visits);
  }

let around size = sum { count = 0; visits = 1 } size
let leaf o = Leaf o
let lamp l = Lamp l

let again (within : Trail.t) node =
  match (within, node) with
  | Start, _ | _, (Many _ | Changed _ | Named _) -> node
  | _, Leaf o -> Leaf { o with origin = Origin.again within o.origin }
  | _, Lamp l -> Lamp (Light.with_origin (Origin.again within l.origin) l)

let many nodes =
  let none = { count = 0; visits = 0 } in
  let add total node = sum total (size node) in
  Many { nodes; size = around (List.fold_left add none nodes) }

let changed change node = Changed { change; node; size = around (size node) }
let named named node = Named { named; node; size = around (size node) }

let describe = function
  | Surface _ -> "a surface"
  | Light _ -> "a light"
  | Object _ -> "an object"

open Raylab_geometry
open Raylab_scene

type t = Surface of Surface.t | Light of node | Object of node

and node =
  | Leaf of Object.t
  | Lamp of Light.t
  | Many of { nodes : node list; count : int }
  | Changed of Change.t * node

let rec count = function
  | Leaf _ | Lamp _ -> 1
  | Many { count; _ } -> count
  | Changed (_, node) -> count node

let many nodes =
  Many { nodes; count = List.fold_left (fun n node -> n + count node) 0 nodes }

let describe = function
  | Surface _ -> "a surface"
  | Light _ -> "a light"
  | Object _ -> "an object"

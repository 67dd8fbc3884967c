open Raylab_geometry
open Raylab_scene
open Raylab_expression

(* Each list begins with what came last. A group keeps its nodes, and a scene
   what becomes of them. *)
type t = {
  keeps_nodes : bool;
  mutable nodes : Thing.node list;
  mutable lights : Light.t list;
  mutable objects : Object.t list;
}

let make keeps_nodes = { keeps_nodes; nodes = []; lights = []; objects = [] }
let scene () = make false
let group () = make true
let lights sink = List.rev sink.lights
let objects sink = List.rev sink.objects
let node sink = Thing.many (List.rev sink.nodes)

let rec place sink change (node : Thing.node) =
  match node with
  | Leaf o -> sink.objects <- Object.transformed change o :: sink.objects
  | Lamp l -> sink.lights <- Light.transformed change l :: sink.lights
  | Many { nodes; _ } -> List.iter (place sink change) nodes
  | Changed (own, node) -> place sink (Change.compose change own) node

let add sink span (node : Thing.node) =
  match node with
  | _ when sink.keeps_nodes -> sink.nodes <- node :: sink.nodes
  | Leaf o -> sink.objects <- o :: sink.objects
  | Lamp l -> sink.lights <- l :: sink.lights
  | Many _ | Changed _ -> (
      try place sink Change.identity node
      with Invalid_argument _ ->
        Fault.fail span "its modifiers leave the range of numbers")

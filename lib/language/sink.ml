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

(* What is around the nodes that are still to be placed. *)
type around = { change : Change.t; placed : Origin.placed }

let add_object sink { change; placed } (o : Object.t) =
  let origin = Origin.place placed o.origin in
  let o = Object.transformed change o in
  sink.objects <- { o with origin } :: sink.objects

let add_light sink { change; placed } (l : Light.t) =
  let light = Light.transformed change l in
  let light = Light.with_origin (Origin.place placed l.origin) light in
  sink.lights <- light :: sink.lights

(* On a list of its own and not on the stack: groups that have names may be
   nested as often as there are names. *)
let rec place sink = function
  | [] -> ()
  | (_, []) :: rest -> place sink rest
  | (around, node :: nodes) :: rest -> (
      let rest = (around, nodes) :: rest in
      match (node : Thing.node) with
      | Leaf o ->
          add_object sink around o;
          place sink rest
      | Lamp l ->
          add_light sink around l;
          place sink rest
      | Many { nodes; _ } -> place sink ((around, nodes) :: rest)
      | Changed { change; node; _ } ->
          let change = Change.compose around.change change in
          place sink (({ around with change }, [ node ]) :: rest)
      | Named { named = { name; at; within }; node; _ } ->
          let placed =
            Origin.By_name { name; at; within; around = around.placed }
          in
          place sink (({ around with placed }, [ node ]) :: rest))

let at_once = { change = Change.identity; placed = At_once }

let add sink (run : _ Value.run) span (node : Thing.node) =
  match node with
  | _ when sink.keeps_nodes -> sink.nodes <- node :: sink.nodes
  | Leaf o -> sink.objects <- o :: sink.objects
  | Lamp l -> sink.lights <- l :: sink.lights
  | Many _ | Changed _ | Named _ -> (
      let { Thing.count; visits } = Thing.size node in
      Budget.steps run.budget span (visits - count);
      try place sink [ (at_once, [ node ]) ]
      with Invalid_argument _ ->
        Fault.fail span "its modifiers leave the range of numbers")

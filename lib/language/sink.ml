open Raylab_geometry
open Raylab_scene
open Raylab_expression

(* Each list begins with what came last. A grouping keeps its nodes, and a scene
   what becomes of them. *)
type t = {
  grouping : Thing.grouping option;
  mutable nodes : Thing.node list;
  mutable lights : Light.t list;
  mutable objects : Object.t list;
}

let make grouping = { grouping; nodes = []; lights = []; objects = [] }
let scene () = make None
let grouping grouping = make (Some grouping)
let lights sink = List.rev sink.lights
let objects sink = List.rev sink.objects
let nodes sink = List.rev sink.nodes

(* What is around the nodes that are still to be placed. *)
type around = {
  change : Change.t;
  placed : Origin.placed;
  shadowless : bool;
  unfading : bool;
}

let at_once =
  {
    change = Change.identity;
    placed = At_once;
    shadowless = false;
    unfading = false;
  }

let changed around change =
  { around with change = Change.compose around.change change }

let named around { Thing.name; at; within } =
  let placed = Origin.By_name { name; at; within; around = around.placed } in
  { around with placed }

let object_ { change; placed; _ } (o : Object.t) =
  Object.transformed change o
  |> Object.with_origin (Origin.place placed o.origin)

let add_object sink { shadowless; _ } o =
  let o = if shadowless then Object.shadowless o else o in
  sink.objects <- o :: sink.objects

let add_light sink { change; placed; unfading; _ } (l : Light.t) =
  let light = Light.transformed change l in
  let light = if unfading then Light.unfading light else light in
  let light = Light.with_origin (Origin.place placed l.origin) light in
  sink.lights <- light :: sink.lights

(* {1 Out of groupings} *)

let operation : Thing.grouping -> Solid.operation = function
  | Together -> Union
  | Solid operation -> operation

(* A group in a solid is the union of what is in it. *)
let rec tree around : Thing.node -> Object.t Solid.tree = function
  | Leaf o -> Member (object_ around o)
  | Group { grouping; nodes; _ } ->
      Change.share around.change;
      Combined (operation grouping, List.map (tree around) nodes)
  | Changed { change; node; _ } -> tree (changed around change) node
  | Named { named = name; node; _ } -> tree (named around name) node
  | Lamp _ | Shadowless _ | Unfading _ ->
      invalid_arg "Sink: no part of a solid"

let solid around origin node =
  let origin = Origin.place around.placed origin in
  Object.solid ~origin (tree around node)

(* On a list of its own and not on the stack: groups that have names may be
   nested as often as there are names. *)
let rec place sink = function
  | [] -> ()
  | (_, []) :: rest -> place sink rest
  | (around, node :: nodes) :: rest -> (
      let rest = (around, nodes) :: rest in
      match (node : Thing.node) with
      | Leaf o ->
          add_object sink around (object_ around o);
          place sink rest
      | Lamp l ->
          add_light sink around l;
          place sink rest
      | Group { grouping = Together; nodes; _ } ->
          Change.share around.change;
          place sink ((around, nodes) :: rest)
      | Group { grouping = Solid _; origin; size; _ } ->
          if size.count > 0 then
            add_object sink around (solid around origin node);
          place sink rest
      | Changed { change; node; _ } ->
          place sink ((changed around change, [ node ]) :: rest)
      | Named { named = name; node; _ } ->
          place sink ((named around name, [ node ]) :: rest)
      | Shadowless { node; _ } ->
          place sink (({ around with shadowless = true }, [ node ]) :: rest)
      | Unfading { node; _ } ->
          place sink (({ around with unfading = true }, [ node ]) :: rest))

(* {1 Into them} *)

let require_fit span grouping node =
  match Thing.unfit node with
  | None -> ()
  | Some { what; why; advice } ->
      Fault.fail span ~advice
        (Printf.sprintf "%s cannot be part of %s: it %s" what
           (Thing.a (Thing.word grouping))
           why)

let add sink (run : _ Value.run) span (node : Thing.node) =
  match (sink.grouping, node) with
  | Some grouping, _ ->
      if grouping <> Thing.Together then require_fit span grouping node;
      sink.nodes <- node :: sink.nodes
  | None, Leaf o -> sink.objects <- o :: sink.objects
  | None, Lamp l -> sink.lights <- l :: sink.lights
  | None, (Group _ | Changed _ | Named _ | Shadowless _ | Unfading _) -> (
      let { Thing.count; visits; _ } = Thing.size node in
      Budget.steps run.budget span (visits - count);
      try place sink [ (at_once, [ node ]) ]
      with Invalid_argument _ ->
        Fault.fail span "its modifiers leave the range of numbers")

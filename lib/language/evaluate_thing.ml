open Raylab_source
open Raylab_geometry
open Raylab_scene
open Raylab_expression

type block =
  Check.t ->
  Scope.t ->
  at:Span.t ->
  Syntax.item list ->
  Check.frame ->
  Sink.t ->
  unit

(* In place of what is wrong, and of no consequence then. *)
let some_shape = Shape.sphere ~centre:Vec3.zero ~radius:1.
let some_light = Light.spherical ~intensity:0. ~color:Color.black

(* What is made in the calls and rounds that are going on. *)
let placeable (frame : Check.frame) node =
  { Thing.node; born = frame.run.budget.steps }

let origin (frame : Check.frame) { Span.start; _ } =
  Origin.make ~at:start ~within:frame.run.trail

let shape check scope span shape surface =
  let shape =
    Evaluate_written.compile check scope span ~default:some_shape shape
  and surface = Evaluate_surface.compile check scope surface in
  let make frame =
    let shape = shape frame in
    let surface = surface frame in
    let o = Object.make ~origin:(origin frame span) shape surface in
    Thing.Object (placeable frame (Thing.leaf o))
  in
  Check.whole check make

let light check scope span light =
  let default = some_light ~position:Vec3.zero in
  let light = Evaluate_written.compile check scope span ~default light in
  let make frame =
    let light = Light.with_origin (origin frame span) (light frame) in
    Thing.Light (placeable frame (Thing.lamp light))
  in
  Check.whole check make

(* What recurses on solids has room for it. *)
let max_depth = 1_000

(* Of nothing may also be what has only parts in error, which are told. *)
let check_solid check span grouping nodes node =
  let word = Thing.word grouping in
  if Check.failed check then ()
  else if nodes = [] && grouping <> Thing.Solid Union then
    Fault.fail span
      (Printf.sprintf "%s of nothing" (Thing.a word))
      ~advice:"it needs at least one object"
  else if (Thing.size node).depth > max_depth then
    Fault.fail span "solids are nested deeper than 1,000"

let group check span grouping body : Thing.t Check.ready =
 fun frame ->
  let sink = Sink.grouping grouping in
  body frame sink;
  let origin = origin frame span in
  let nodes = Sink.nodes sink in
  let node = Thing.group ~origin grouping nodes in
  if grouping <> Together then check_solid check span grouping nodes node;
  Thing.Object (placeable frame node)

(* What a call makes knows the call. What it only returns has been made before,
   and is placed by it as by a name. *)
let is_made_by (e : Expression.t) before born =
  match e.desc with Call _ -> born > before | _ -> false

let named (frame : Check.frame) (e : Expression.t) name before placeable =
  let { Thing.node; born } = placeable in
  if is_made_by e before born then placeable
  else
    let within = frame.run.trail in
    let named = { Thing.name; at = e.span.start; within } in
    { placeable with node = Thing.named named node }

let reference scope e =
  let code = Code.compile scope e and name = Expression.to_string e in
  fun (frame : Check.frame) ->
    let before = frame.run.budget.steps in
    match code frame with
    | Value.Thing (Thing.Object o) ->
        Thing.Object (named frame e name before o)
    | Value.Thing (Light l) -> Light (named frame e name before l)
    | value -> Operation.wanted frame.run e "an object or a light" value

let bare block check scope { Syntax.thing; span; _ } =
  match thing with
  | Shape (written, surface) -> shape check scope span written surface
  | Light written -> light check scope span written
  | Group (grouping, items) ->
      group check span grouping (block check scope ~at:span items)
  | Reference e -> reference scope e

let changed frame modifiers placeable =
  match List.map (fun modifier -> modifier frame) modifiers with
  | [] -> placeable
  | modifiers ->
      let change = Change.of_modifiers modifiers in
      { placeable with Thing.node = Thing.changed change placeable.Thing.node }

let with_node f placeable =
  { placeable with Thing.node = f placeable.Thing.node }

let no_shadow span =
  Fault.fail span "a light has no shadow"
    ~advice:"shadowless is for objects: a light has the modifiers that move it"

let no_light span =
  Fault.fail span "there is no light that could be unfading"
    ~advice:"unfading is for lights, and for groups with lights in them"

let modified span (what : Syntax.what) thing =
  match (what, thing) with
  | Shadowless, Thing.Light _ -> no_shadow span
  | Shadowless, Object o -> Thing.Object (with_node Thing.shadowless o)
  | Unfading, Light l -> Light (with_node Thing.unfading l)
  | Unfading, Object { node; _ } when not (Thing.size node).shines ->
      no_light span
  | Unfading, Object o -> Object (with_node Thing.unfading o)
  | (Shadowless | Unfading | Change _), thing -> thing

let compile block check scope (placed : Syntax.placed) =
  let thing = bare block check scope placed in
  let change ({ what; span } : Syntax.modifier) =
    match what with
    | Change written ->
        let default = Change.Scaled 1. in
        Some (Evaluate_written.compile check scope span ~default written)
    | Shadowless | Unfading -> None
  in
  let changes = List.filter_map change placed.modifiers in
  let modify thing ({ what; span } : Syntax.modifier) =
    modified span what thing
  in
  if placed.modifiers = [] then thing
  else fun frame ->
    let thing =
      match thing frame with
      | Thing.Light light -> Thing.Light (changed frame changes light)
      | Object object_ -> Object (changed frame changes object_)
      | Surface _ as surface -> surface
    in
    List.fold_left modify thing placed.modifiers

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
  fun frame ->
    Check.whole check (fun () ->
        let shape = shape frame in
        let surface = surface frame in
        let o = Object.make ~origin:(origin frame span) shape surface in
        Thing.Object (placeable frame (Thing.leaf o)))

let light check scope span light =
  let default = some_light ~position:Vec3.zero in
  let light = Evaluate_written.compile check scope span ~default light in
  fun frame ->
    Check.whole check (fun () ->
        let light = Light.with_origin (origin frame span) (light frame) in
        Thing.Light (placeable frame (Thing.lamp light)))

let group body frame =
  let sink = Sink.group () in
  body frame sink;
  Thing.Object (placeable frame (Sink.node sink))

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
  | Group items -> group (block check scope ~at:span items)
  | Reference e -> reference scope e

let changed change placeable =
  { placeable with Thing.node = Thing.changed change placeable.Thing.node }

let compile block check scope placed =
  let thing = bare block check scope placed in
  let modifier { Syntax.change; span } =
    Evaluate_written.compile check scope span ~default:(Change.Scaled 1.)
      change
  in
  match List.map modifier placed.modifiers with
  | [] -> thing
  | modifiers -> (
      fun frame ->
        let thing = thing frame in
        let change =
          Change.of_modifiers
            (List.map (fun modifier -> modifier frame) modifiers)
        in
        match thing with
        | Thing.Light light -> Light (changed change light)
        | Object object_ -> Object (changed change object_)
        | Surface _ -> thing)

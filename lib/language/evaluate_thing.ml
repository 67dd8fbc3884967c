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

let shape check scope span shape surface =
  let origin = Origin.Literal span.Span.start in
  let shape =
    Evaluate_written.compile check scope span ~default:some_shape shape
  and surface = Evaluate_surface.compile check scope surface in
  fun frame ->
    Check.whole check (fun () ->
        let shape = shape frame in
        let surface = surface frame in
        Thing.Object (Leaf (Object.make ~origin shape surface)))

let light check scope span light =
  let origin = Origin.Literal span.Span.start in
  let default = some_light ~position:Vec3.zero in
  let light = Evaluate_written.compile check scope span ~default light in
  fun frame ->
    Check.whole check (fun () ->
        Thing.Light (Lamp (Light.with_origin origin (light frame))))

let group body frame =
  let sink = Sink.group () in
  body frame sink;
  Thing.Object (Sink.node sink)

let reference scope e =
  let code = Code.compile scope e in
  fun frame ->
    match code frame with
    | Value.Thing ((Thing.Object _ | Light _) as thing) -> thing
    | value -> Operation.wanted frame.Frame.run e "an object or a light" value

let bare block check scope { Syntax.thing; span; _ } =
  match thing with
  | Shape (written, surface) -> shape check scope span written surface
  | Light written -> light check scope span written
  | Group items -> group (block check scope ~at:span items)
  | Reference e -> reference scope e

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
        | Thing.Light node -> Light (Changed (change, node))
        | Object node -> Object (Changed (change, node))
        | Surface _ -> thing)

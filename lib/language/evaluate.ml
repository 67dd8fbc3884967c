open Raylab_geometry
open Raylab_scene
open Raylab_source
open Raylab_expression

(* Where lights and objects go: into the scene, the last one first, or into a
   group. *)
type sink =
  | Scene of { mutable lights : Light.t list; mutable objects : Object.t list }
  | Group of { mutable nodes : Thing.node list }

type code = Check.frame -> sink -> unit

let rec flatten change node ~light ~object_ =
  match (node : Thing.node) with
  | Leaf o -> object_ change o
  | Lamp l -> light change l
  | Many { nodes; _ } ->
      List.iter (fun node -> flatten change node ~light ~object_) nodes
  | Changed (own, node) ->
      flatten (Similarity.compose change own) node ~light ~object_

let add (frame : Check.frame) span sink node =
  Budget.make frame.run.budget span (Thing.count node);
  match (sink, node) with
  | Group group, _ -> group.nodes <- node :: group.nodes
  | Scene scene, Thing.Leaf o -> scene.objects <- o :: scene.objects
  | Scene scene, Lamp l -> scene.lights <- l :: scene.lights
  | Scene scene, _ -> (
      let light change l =
        scene.lights <- Light.transformed change l :: scene.lights
      and object_ change (o : Object.t) =
        let shape = Shape.transformed change o.shape in
        scene.objects <- { o with shape } :: scene.objects
      in
      try flatten Similarity.identity node ~light ~object_
      with Invalid_argument _ ->
        Fault.fail span "its modifiers leave the range of numbers")

(* {1 Things} *)

let compile_shape check scope = function
  | Syntax.Sphere { centre; radius } ->
      let centre = Check.vector check scope "the centre" centre
      and radius = Check.number check scope Positive "the radius" radius in
      fun frame ->
        let centre = centre frame in
        let radius = radius frame in
        fun () -> Shape.sphere ~centre ~radius
  | Plane { point; normal } ->
      let point = Check.vector check scope "the point" point
      and normal = Check.direction check scope "the normal" normal in
      fun frame ->
        let point = point frame in
        let normal = normal frame in
        fun () -> Shape.plane ~point ~normal

let too_deep = "mixes are nested deeper than 1,000"

let rec compile_surface check scope nesting { Syntax.finish; span } :
    Surface.t Check.parameter =
  match finish with
  | Reflective -> fun _ -> Surface.reflective
  | Diffusive c ->
      let color = Check.color check scope "the surface's colour" c in
      fun frame -> Surface.diffusive (color frame)
  | Luminous c ->
      let color = Check.color check scope "the surface's colour" c in
      fun frame -> Surface.luminous (color frame)
  | Mixed _ when nesting = Surface.max_nesting ->
      fun frame -> fail_deep check frame span
  | Mixed parts ->
      let part (weight, s) =
        ( Check.number check scope Non_negative "the weight" weight,
          compile_surface check scope (nesting + 1) s )
      in
      let parts = List.map part parts in
      fun frame ->
        let part (weight, surface) =
          let weight = weight frame in
          (weight, surface frame)
        in
        let parts = List.map part parts in
        Check.attempt check frame Surface.reflective (fun () ->
            try Surface.mixed parts
            with Invalid_argument _ -> Fault.fail span too_deep)
  | Chosen e ->
      let code = Code.compile scope e in
      fun frame ->
        Check.attempt check frame Surface.reflective (fun () ->
            match code frame with
            | Value.Thing (Surface s) -> s
            | value -> Operation.wanted frame.Code.run e "a surface" value)

and fail_deep check frame span =
  Check.attempt check frame Surface.reflective (fun () ->
      Fault.fail span too_deep
        ~advice:
          "a mix in a mix may be written as one, with its weights multiplied")

let compile_light check scope { Syntax.source; intensity; color } =
  let number = Check.number check scope Non_negative in
  let intensity = number "the intensity" intensity
  and color = Check.color check scope "the light's colour" color in
  match source with
  | Directional direction ->
      let direction = Check.direction check scope "the direction" direction in
      fun frame ->
        let intensity = intensity frame in
        let color = color frame in
        let direction = direction frame in
        fun () -> Light.directional ~intensity ~color ~direction
  | Spherical position ->
      let position =
        Check.vector check scope "the light's position" position
      in
      fun frame ->
        let intensity = intensity frame in
        let color = color frame in
        let position = position frame in
        fun () -> Light.spherical ~intensity ~color ~position

let rotation axis angle =
  Similarity.rotated
    ~axis:(Direction.of_vec3_exn axis)
    ~sin:(Degrees.sin angle) ~cos:(Degrees.cos angle)

let compile_modifier check scope { Syntax.change; span } =
  match change with
  | Scaled k ->
      let k = Check.number check scope Positive "the factor" k in
      fun frame -> Similarity.scaled (k frame)
  | Translated way ->
      let way = Check.vector check scope "the way" way in
      fun frame -> Similarity.translated (way frame)
  | Rotated (axis, angle) ->
      let axis = Check.direction check scope "the axis" axis
      and angle = Check.number check scope Finite "the angle" angle in
      fun frame ->
        let axis = axis frame in
        rotation axis (angle frame)
  | Stretched _ ->
      fun frame ->
        Check.attempt check frame Similarity.identity (fun () ->
            Fault.fail span "shapes cannot be stretched yet"
              ~advice:"scaled changes the size in all directions alike")

(* {1 Items} *)

let nowhere = { Span.start = 0; stop = 0 }

let report check span ~advice message =
  Findings.error (Check.findings check) span message ~advice

let protect check (frame : Check.frame) f =
  Check.attempt check frame () (fun () -> Check.whole check f)

let in_group check frame span body =
  let group = Group { nodes = [] } in
  ignore check;
  body frame group;
  match group with
  | Group { nodes } -> Thing.many (List.rev nodes)
  | Scene _ -> Fault.fail span "no group"

let rec compile_thing check scope (placed : Syntax.placed) :
    Check.frame -> Thing.t =
  let make = compile_bare check scope placed in
  match List.map (compile_modifier check scope) placed.modifiers with
  | [] -> make
  | modifiers -> (
      fun frame ->
        let thing = make frame in
        let change =
          List.fold_left
            (fun before modifier -> Similarity.compose (modifier frame) before)
            Similarity.identity modifiers
        in
        match thing with
        | Thing.Light node -> Light (Changed (change, node))
        | Object node -> Object (Changed (change, node))
        | Surface _ -> thing)

and compile_bare check scope { Syntax.thing; span; _ } =
  let origin = Origin.Literal span.start in
  match thing with
  | Shape (shape, surface) ->
      let shape = compile_shape check scope shape
      and surface = compile_surface check scope 0 surface in
      fun frame ->
        let made =
          Check.whole check (fun () ->
              let shape = shape frame in
              let surface = surface frame in
              (shape, surface))
        in
        let shape, surface = made in
        Thing.Object (Leaf (Object.make ~origin (shape ()) surface))
  | Light light ->
      let light = compile_light check scope light in
      fun frame ->
        let build = Check.whole check (fun () -> light frame) in
        Thing.Light (Lamp (Light.with_origin origin (build ())))
  | Group items ->
      let body = compile_block check scope ~at:span items in
      fun frame -> Thing.Object (in_group check frame span body)
  | Reference e -> (
      let code = Code.compile scope e in
      fun frame ->
        match code frame with
        | Value.Thing ((Object _ | Light _) as thing) -> thing
        | value ->
            Operation.wanted frame.Code.run e "an object or a light" value)

and compile_item check scope ~at (item : Syntax.item) : Scope.t * code =
  match item with
  | Ready_object o ->
      let node = Thing.Leaf o in
      ( scope,
        fun frame sink ->
          (* what a block repeats is not written each time *)
          Budget.make frame.run.budget at 1;
          add_ready sink node )
  | Ready_light l ->
      let node = Thing.Lamp l in
      ( scope,
        fun frame sink ->
          (* what a block repeats is not written each time *)
          Budget.make frame.run.budget at 1;
          add_ready sink node )
  | Placed placed ->
      let thing = compile_thing check scope placed in
      ( scope,
        fun frame sink ->
          protect check frame (fun () ->
              match thing frame with
              | Thing.Light node | Object node ->
                  add frame placed.span sink node
              | Surface _ -> ()) )
  | Definition d ->
      let scope, define = compile_definition check scope d in
      (scope, fun frame _ -> define frame)
  | For { name; name_span; range; body } ->
      (scope, compile_for check scope name name_span range body)
  | If { condition; yes; no } ->
      let test = Code.truth scope condition in
      let at = condition.span in
      let yes = compile_block check scope ~at yes
      and no = compile_block check scope ~at no in
      ( scope,
        fun frame sink ->
          protect check frame (fun () ->
              if test frame then yes frame sink else no frame sink) )

and add_ready sink node =
  match (sink, node) with
  | Group group, _ -> group.nodes <- node :: group.nodes
  | Scene scene, Thing.Leaf o -> scene.objects <- o :: scene.objects
  | Scene scene, Lamp l -> scene.lights <- l :: scene.lights
  | Scene _, _ -> ()

and compile_for check scope name name_span range body : code =
  let each = Code.rounds scope name_span range in
  let inner, binding = Scope.bind scope name name_span in
  let body = compile_block check inner ~at:name_span body in
  fun frame sink ->
    protect check frame (fun () ->
        let run = frame.run in
        let around = run.stack in
        each frame (fun value ->
            Code.set binding frame value;
            run.stack <- Round { name; value; at = name_span } :: around;
            body frame sink);
        run.stack <- around)

and compile_block check scope ~at items : code =
  let check_twice = Hashtbl.create 7 in
  let compile (scope, codes) item =
    tell_twice check check_twice item;
    let scope, code = compile_item check scope ~at item in
    (scope, code :: codes)
  in
  let _, codes = List.fold_left compile (scope, []) items in
  let codes = Array.of_list (List.rev codes) in
  fun frame sink ->
    Array.iter
      (fun code ->
        Budget.step frame.Code.run.budget at;
        code frame sink)
      codes

and tell_twice check names = function
  | Syntax.Definition { name; name_span; _ } -> (
      let key = String.lowercase_ascii name in
      match Hashtbl.find_opt names key with
      | None -> Hashtbl.add names key name_span
      | Some first ->
          let sources = Findings.sources (Check.findings check) in
          report check name_span
            (Printf.sprintf "%s is defined a second time" name)
            ~advice:
              (Printf.sprintf
                 "it is already defined in line %d; choose another name"
                 (Sources.place sources first).line))
  | _ -> ()

(* {1 Definitions} *)

and compile_value check scope (value : Syntax.value) : Thing.t Code.t =
  match value with
  | Expression e -> Code.compile scope e
  | Surface s ->
      let surface = compile_surface check scope 0 s in
      fun frame ->
        Value.Thing (Surface (Check.whole check (fun () -> surface frame)))
  | Thing placed ->
      let thing = compile_thing check scope placed in
      fun frame -> Value.Thing (Check.whole check (fun () -> thing frame))

and compile_definition check scope d =
  let { Syntax.name; name_span; parameters; value } = d in
  let inner, binding =
    Scope.bind scope name name_span ~is_defined:(Option.is_some parameters)
  in
  let code =
    match parameters with
    | None -> compile_value check inner value
    | Some parameters ->
        Code.func inner ~name parameters (fun scope ->
            compile_value check scope value)
  in
  binding.is_defined <- true;
  ( inner,
    fun (frame : Check.frame) ->
      Code.set binding frame
        (Check.attempt check frame Value.Undefined (fun () -> code frame)) )

(* {1 The scene} *)

let start check time =
  let findings = Check.findings check in
  let run =
    { Value.budget = Budget.scene (); describe = Thing.describe; stack = [] }
  in
  let report span ~advice message =
    Findings.error findings span message ~advice
  in
  let scope, binding = Scope.bind (Scope.start report) "time" nowhere in
  let frame = Code.start run ~size:8 in
  Code.set binding frame (Number time);
  (scope, frame)

(* One item after the other, so that nothing is kept of those that are done. *)
let run_items check scope frame sink names items =
  let rec run scope = function
    | [] -> ()
    | item :: rest ->
        let scope =
          match item with
          | Syntax.Ready_object o ->
              add_ready sink (Leaf o);
              scope
          | item ->
              tell_twice check names item;
              let scope, code = compile_item check scope ~at:nowhere item in
              Code.need frame (Scope.size scope);
              code frame sink;
              scope
        in
        run scope rest
  in
  run scope items

let run_header check scope frame header names items =
  List.fold_left
    (fun scope item ->
      match (item : Syntax.header_item) with
      | Setting setting ->
          Code.need frame (Scope.size scope);
          Check_header.set header scope setting frame;
          scope
      | Header_definition d ->
          tell_twice check names (Syntax.Definition d);
          let scope, define = compile_definition check scope d in
          Code.need frame (Scope.size scope);
          define frame;
          scope)
    scope items

let scene ?(time = 0.) sources (syntax : Syntax.t) =
  let findings = Findings.start sources in
  let check = Check.start findings in
  let scope, frame = start check time in
  let header = Check_header.start check and names = Hashtbl.create 17 in
  let scene = Scene { lights = []; objects = [] } in
  (try
     let scope = run_header check scope frame header names syntax.header in
     Check_header.finish header syntax.header_end;
     run_items check scope frame scene names syntax.items
   with Fault.Found fault -> Findings.fault findings fault frame.run.stack);
  match (Findings.errors findings, scene) with
  | [], Scene { lights; objects } ->
      Ok
        (Check_header.scene header ~files:(Sources.table sources)
           ~lights:(List.rev lights) ~objects:(List.rev objects))
  | errors, _ -> Error errors

open Raylab_geometry
open Raylab_scene
open QCheck2
open Gen

let everyday = float_range (-10.) 10.

let corners =
  let sizes =
    [ 5e-324; 1e-310; 0x1p-1022; 1e-200; 1e-154; 1e-5; 1.; 1e15; 1e154; 1e200 ]
  in
  let sizes = 0. :: 1e300 :: max_float :: sizes in
  sizes @ List.map Float.neg sizes

(* Every bit pattern but those of NaN and infinity, which become 1. *)
let any_bits =
  let finite bits =
    let x = Int64.float_of_bits bits in
    if Float.is_finite x then x else 1.
  in
  map finite int64

let extreme = frequency [ (3, everyday); (2, oneofl corners); (1, any_bits) ]

let hostile =
  frequency [ (6, extreme); (1, oneofl [ nan; infinity; neg_infinity ]) ]

let at_least_0 number = map abs_float number
let positive number = map (fun x -> if x = 0. then 1. else abs_float x) number
let vec3 number = map3 Vec3.make number number number

let direction number =
  let default = Build.dir 0. 1. 0. in
  map (Direction.of_vec3_or default) (vec3 number)

let ray number =
  map2
    (fun origin direction -> Ray.make ~origin ~direction)
    (vec3 number) (direction number)

(* Factors that are no power of 2, so that they round. *)
let modifier number =
  let factor = oneofl [ 0.3; 0.7; 1.; 1.3; 2.6 ] in
  let signed = oneof [ factor; map Float.neg factor ] in
  oneof
    [
      map (fun k -> Change.Scaled k) factor;
      map (fun factors -> Change.Stretched factors) (vec3 signed);
      map (fun way -> Change.Translated way) (vec3 number);
      map2
        (fun axis angle ->
          let open Raylab_expression in
          let sin = Degrees.sin angle and cos = Degrees.cos angle in
          Change.Rotated { axis; angle; sin; cos })
        (direction number) (float_range (-360.) 360.);
    ]

let change number =
  map Change.of_modifiers (list_size (1 -- 4) (modifier number))

(* What numbers do not make is a ball. *)
let fitting make =
  try make ()
  with Invalid_argument _ -> Shape.sphere ~centre:Vec3.zero ~radius:1.

let along (d : Direction.t) = (d :> Vec3.t)

let box number =
  map2
    (fun corner opposite ->
      fitting (fun () -> Shape.box_between ~corner ~opposite))
    (vec3 number) (vec3 number)

let cylinder number =
  map3
    (fun a b radius -> fitting (fun () -> Shape.cylinder a b ~radius))
    (vec3 number) (vec3 number) (positive number)

let cone number =
  map3
    (fun (a, radius_a) b radius_b ->
      fitting (fun () -> Shape.cone a radius_a b radius_b))
    (pair (vec3 number) (at_least_0 number))
    (vec3 number)
    (oneof [ at_least_0 number; pure 0. ])

let torus number =
  map3
    (fun centre axis (a, b) ->
      Shape.torus ~centre ~axis:(along axis) ~ring:(Float.max a b)
        ~tube:(Float.min a b))
    (vec3 number) (direction number)
    (pair (positive number) (positive number))

let disc number =
  map3
    (fun centre normal radius ->
      Shape.disc ~centre ~normal:(along normal) ~radius)
    (vec3 number) (direction number) (positive number)

let triangle number =
  map3
    (fun a b c -> fitting (fun () -> Shape.triangle a b c))
    (vec3 number) (vec3 number) (vec3 number)

let quad number =
  map3
    (fun corner edge other ->
      fitting (fun () -> Shape.quad ~corner ~edge ~other))
    (vec3 number) (vec3 number) (vec3 number)

let sphere number =
  map2
    (fun centre radius -> Shape.sphere ~centre ~radius)
    (vec3 number) (positive number)

let plane number =
  map2
    (fun point normal -> Shape.plane ~point ~normal:(along normal))
    (vec3 number) (direction number)

let mesh meshes = map (fun mesh -> Shape.Mesh mesh) (oneofl meshes)

let solid number =
  oneof
    [ sphere number; box number; cylinder number; cone number; torus number ]

let simple_shape number =
  frequency
    [
      (5, solid number);
      (1, plane number);
      (1, disc number);
      (1, triangle number);
      (1, quad number);
      (1, mesh Meshes.all);
    ]

let changed_shape number =
  let changed shape change =
    try Shape.transformed change shape with Invalid_argument _ -> shape
  in
  frequency
    [
      (3, simple_shape number);
      (1, map2 changed (simple_shape number) (change number));
    ]

(* Up to three parts, nested up to three deep. *)
let solid_tree member =
  let rec at_depth n =
    if n = 0 then map (fun m -> Solid.Member m) member
    else
      let* operation = oneofl Solid.[ Union; Intersection; Difference ]
      and* parts = list_size (1 -- 3) (at_depth (n - 1)) in
      pure (Solid.Combined (operation, parts))
  in
  let* depth = 1 -- 3 in
  at_depth depth

let solid_shape number =
  let or_other shape =
    if Shape.is_solid shape then pure shape
    else oneof [ mesh Meshes.solid; sphere number ]
  in
  changed_shape number >>= or_other

let shape number =
  frequency
    [
      (3, changed_shape number);
      (1, map Shape.solid (solid_tree (solid_shape number)));
    ]

let color number =
  let channel = at_least_0 number in
  map3 Color.make channel channel channel

let index number = oneof [ oneofl [ 1.; 1.33; 1.5; 0.5 ]; positive number ]

let simple_surface number =
  oneof
    [
      map Surface.diffusive (color number);
      pure Surface.reflective;
      map Surface.luminous (color number);
      map2
        (fun sharpness c -> Surface.glossy ~sharpness c)
        (at_least_0 number) (color number);
      map2
        (fun index c -> Surface.refractive ~index c)
        (index number) (color number);
      map2
        (fun index c -> Surface.glass ~index c)
        (index number) (color number);
    ]

(* {1 Patterns}

   Of expressions that have a value at every point: [k], [f(p)] and numbers that
   depend on where the point is. *)

let written desc =
  { Raylab_expression.Expression.desc; span = { start = 0; stop = 0 } }

let beyond point letter x a b =
  let open Raylab_expression.Expression in
  let name = written (Name point) in
  let part = written (Part (name, letter)) in
  let test = written (Binary (Greater, part, written (Number x))) in
  written (If (test, a, b))

let number_at point number =
  let literal =
    map (fun x -> written (Raylab_expression.Expression.Number x))
  in
  let positive = literal (at_least_0 number) in
  map3
    (fun letter x (a, b) -> beyond point letter x a b)
    (oneofl [ 'x'; 'y'; 'z' ])
    (float_range 0.1 5.) (pair positive positive)

let closed name body number =
  let* k = at_least_0 number
  and* of_f = number_at "q" number
  and* third = number_at name number in
  let open Raylab_expression in
  let span = { Raylab_source.Span.start = 0; stop = 0 } in
  let value = { Expression.label = None; value = written (Name name) } in
  let call =
    written (Call { name = "f"; name_span = span; arguments = [ value ] })
  in
  let k_name = written (Name "k") in
  let f_body = beyond "q" 'x' 0.37 k_name of_f in
  let q = { Expression.name = "q"; span; default = None } in
  pure
    {
      Closed.name;
      body = body k_name (written (List [ k_name; call; third ])) third;
      definitions =
        [
          ("k", Value (Number k));
          ("f", Defined { parameters = [ q ]; body = f_body });
        ];
    }

let pattern number =
  let open Raylab_expression.Expression in
  let word word arguments = written (Word { word; arguments }) in
  let* body =
    oneofl
      [
        (fun _ color _ -> word "diffusive" [ (Color, color) ]);
        (fun _ color _ -> word "luminous" [ (Color, color) ]);
        (fun k color third ->
          word "mixed"
            [
              (Weight, k); (Surface, word "diffusive" [ (Color, color) ]);
              (Weight, third); (Surface, word "reflective" []);
            ]);
        (fun _ color _ ->
          word "checker"
            [
              (Number, written (Number 0.7));
              (Surface, word "luminous" [ (Color, color) ]);
              (Surface, word "reflective" []);
            ]);
      ]
  in
  closed "p" body number
[@@ocamlformat "disable"]

let sky number = closed "d" (fun _ color _ -> color) number

let surface number =
  let rec at_depth n =
    if n = 0 then simple_surface number
    else
      let part = pair (at_least_0 number) (at_depth (n - 1))
      and tinted = pair (color number) (at_depth (n - 1)) in
      frequency
        [
          (2, simple_surface number);
          (1, map Surface.mixed (list_size (1 -- 3) part));
          (1, map Surface.tinted (list_size (1 -- 3) tinted));
          (1, map Surface.varying (pattern number));
          ( 1,
            map3 Surface.checker (positive number)
              (at_depth (n - 1))
              (at_depth (n - 1)) );
        ]
  in
  at_depth 3

(* What numbers do not make shines from a point. *)
let spot_light number ~intensity ~color =
  let* position = vec3 number
  and* target = vec3 number
  and* a = float_range 0. 179.9
  and* b = frequency [ (4, float_range 0. 179.9); (1, pure 0.) ] in
  let inner = Float.min a b and outer = Float.max a b in
  match Beam.make ~position ~target ~inner ~outer with
  | Ok beam -> pure (Light.spot ~intensity ~color beam)
  | Error _ -> pure (Light.spherical ~intensity ~color ~position)

let area_light number ~intensity ~color =
  let* corner = vec3 number
  and* edge = vec3 number
  and* other = frequency [ (4, vec3 number); (1, pure Vec3.zero) ]
  and* count = 1 -- 3 in
  match Pane.make ~corner ~edge ~other ~count with
  | pane -> pure (Light.area ~intensity ~color pane)
  | exception Invalid_argument _ ->
      pure (Light.spherical ~intensity ~color ~position:corner)

let light number =
  let* intensity = at_least_0 number
  and* color = color number
  and* is_unfading = frequency [ (5, pure false); (1, pure true) ] in
  let* light =
    frequency
      [
        ( 3,
          map
            (fun position -> Light.spherical ~intensity ~color ~position)
            (vec3 number) );
        ( 3,
          map
            (fun (d : Direction.t) ->
              Light.directional ~intensity ~color ~direction:(d :> Vec3.t))
            (direction number) );
        (2, spot_light number ~intensity ~color);
        (2, area_light number ~intensity ~color);
      ]
  in
  pure (if is_unfading then Light.unfading light else light)

let object_ number =
  let plain =
    map2 (fun s f -> Object.make s f) (changed_shape number) (surface number)
  in
  let part =
    map2 (fun s f -> Object.make s f) (solid_shape number) (surface number)
  in
  let solid = map (fun tree -> Object.solid tree) (solid_tree part) in
  let* o = frequency [ (5, plain); (1, solid) ]
  and* is_shadowless = frequency [ (7, pure false); (1, pure true) ] in
  pure (if is_shadowless then Object.shadowless o else o)

let film =
  let any =
    map3
      (fun samples exposure srgb -> Film.make ~samples ~exposure ~srgb ())
      (1 -- 16) (positive extreme) bool
  in
  frequency [ (3, pure Film.default); (1, any) ]

let lens number =
  let any =
    map2
      (fun aperture focus -> Lens.make ?focus aperture)
      (at_least_0 number)
      (option (positive number))
  in
  frequency [ (3, pure Lens.pinhole); (1, any) ]

let viewpoint number =
  let make (eye, look_at, up) =
    match Viewpoint.make ~look_at ~up eye with
    | Ok viewpoint -> viewpoint
    | Error _ | (exception Invalid_argument _) -> Viewpoint.before_origin 1.
  in
  map make (triple (vec3 number) (vec3 number) (vec3 number))

let camera ?(max_side = 12) number =
  let size = positive number in
  let* width = 1 -- max_side
  and* height = 1 -- max_side
  and* canvas_width = size
  and* canvas_height = size
  and* depth = size
  and* viewpoint = viewpoint number
  and* fov = float_range 0.1 179.9
  and* kind = 0 -- 3 in
  let usual = Camera.make ~width ~height ~canvas_width ~canvas_height ~depth in
  match kind with
  | 0 -> pure (Camera.with_viewpoint viewpoint usual)
  | 1 -> (
      match Camera.of_fov ~width ~height ~fov viewpoint with
      | camera -> pure camera
      | exception Invalid_argument _ -> pure usual)
  | _ -> pure usual

let scene ?max_side number =
  let* camera = camera ?max_side number
  and* film = film
  and* lens = lens number
  and* background = color number
  and* ambient = frequency [ (3, pure Color.black); (1, color number) ]
  and* ray_depth = 0 -- 6
  and* lights = list_size (0 -- 4) (light number)
  and* objects = list_size (0 -- 6) (object_ number)
  and* sky = sky number
  and* has_sky = frequency [ (4, pure false); (1, pure true) ] in
  let scene =
    Scene.make ~lens ~film ~background ~ambient ~ray_depth ~lights ~objects
      camera
  in
  pure
    (if has_sky then Scene.with_sky (Background.varying sky) scene else scene)

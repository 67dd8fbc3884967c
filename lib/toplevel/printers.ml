open Raylab_geometry
open Raylab_scene
open Raylab_language
open Raylab_tracer
open Raylab_explanation

let vec3 = Vec3.pp
let direction = Direction.pp
let ray = Ray.pp
let shape = Shape.pp
let sphere = Sphere.pp
let plane = Plane.pp

let color ppf c =
  Format.fprintf ppf "%a%a" Color.pp c (Swatch.pp_with (Tell.swatches ())) c

let surface = Surface.pp

let meaning ppf { Surface.emission; albedo; mirror } =
  Format.fprintf ppf "emission %a, albedo %a, mirror %a" color emission color
    albedo Number.pp mirror

let light = Light.pp

let incidence ppf { Light.towards; cosine; falloff } =
  Format.fprintf ppf "towards %a, cosine %a, fall-off %a" direction towards
    Number.pp cosine Number.pp falloff

let object_ = Object.pp

let camera ppf (c : Camera.t) =
  Format.fprintf ppf "%d x %d pixels through a canvas of %a x %a from %a"
    c.width c.height Number.pp c.canvas_width Number.pp c.canvas_height vec3
    (Camera.eye c)

let scene = Scene.pp
let scene_error = Scene_error.pp
let hit ppf (h : Hit.t) = Format.fprintf ppf "object %d, %a" h.number Hit.pp h
let event = Event.pp

let events ppf events =
  let n = Seq.length events in
  Format.fprintf ppf "%d %s" n (if n = 1 then "step" else "steps")

let trace ppf t = scene ppf (Trace.scene t)

let verdict ppf : Explain.verdict -> unit = function
  | Faces_away { cosine } ->
      Format.fprintf ppf "faces away, cosine %a" Number.pp cosine
  | Blocked { by; t; point; _ } ->
      Format.fprintf ppf "blocked by object %d, t = %a at %a" by Number.pp t
        vec3 point
  | Lit { cosine; falloff; contribution; _ } ->
      Format.fprintf ppf "lit, cosine %a, fall-off %a, gives %a" Number.pp
        cosine Number.pp falloff color contribution

let explain_light ppf (l : Explain.light) =
  Format.fprintf ppf "light %d: %a" l.number verdict l.verdict

let explain ppf e = Report.pp_with ~swatches:(Tell.swatches ()) ppf e

let surface_hit ppf (h : Explain.surface_hit) =
  Format.fprintf ppf "@[<v>%a@,%a@,%a" hit h.hit object_ h.object_ meaning
    h.meaning;
  List.iter (Format.fprintf ppf "@,%a" explain_light) h.lights;
  Format.fprintf ppf "@,emitted %a + diffused %a + mirrored %a@]" color
    h.emitted color h.diffused color h.mirrored

let outcome ppf : Explain.outcome -> unit = function
  | Chain_ended -> Format.pp_print_string ppf "the chain ended: the background"
  | Missed -> Format.pp_print_string ppf "nothing hit: the background"
  | Hit h -> surface_hit ppf h

let picture ppf p =
  Format.fprintf ppf "picture of %d x %d pixels" (Picture.width p)
    (Picture.height p)

let tally ppf { Tally.primary; reflected; shadow; hits; blocked } =
  Format.fprintf ppf
    "%d primary, %d reflected and %d shadow rays, %d hits, %d lights blocked"
    primary reflected shadow hits blocked

open Raylab_geometry
open Raylab_scene
open Raylab_language
open Raylab_tracer
open Raylab_explanation

let vec3 = Vec3.pp
let direction = Direction.pp
let ray = Broken.at_words Ray.pp
let box = Broken.at_words Box3.pp
let shape = Broken.at_words Shape.pp
let sphere = Broken.at_words Sphere.pp
let plane = Broken.at_words Plane.pp
let box_shape = Broken.at_words Box.pp
let cylinder = Broken.at_words Cylinder.pp
let cone = Broken.at_words Cone.pp
let torus = Broken.at_words Torus.pp
let disc = Broken.at_words Disc.pp
let triangle = Broken.at_words Triangle.pp
let quad = Broken.at_words Quad.pp

let color ppf c =
  Format.fprintf ppf "%a%a" Color.pp c (Swatch.pp_with (Console.swatches ())) c

let surface = Broken.at_words Surface.pp

let lobes ppf lobes =
  Format.fprintf ppf "@[<hov 2>%a@]" (Lobes.pp_with color) lobes

let light = Broken.at_words Light.pp
let object_ = Broken.at_words Object.pp

let camera ppf (c : Camera.t) =
  let { Viewpoint.eye; look_at; up; _ } = c.viewpoint in
  Format.fprintf ppf "@[<hov 2>%d x %d pixels@ " c.width c.height;
  (match c.fov with
  | Some fov -> Format.fprintf ppf "under %a degrees@ " Number.pp fov
  | None ->
      Format.fprintf ppf "through a canvas@ of %a x %a@ " Number.pp
        c.canvas_width Number.pp c.canvas_height);
  Format.fprintf ppf "from %a" vec3 eye;
  if Camera.is_placed c then Format.fprintf ppf "@ towards %a" vec3 look_at;
  if not (Vec3.equal up Viewpoint.default_up) then
    Format.fprintf ppf ",@ up %a" vec3 up;
  Format.fprintf ppf "@]"

let viewpoint = Broken.at_words Viewpoint.pp
let scene = Broken.at_words Scene.pp

(* The excerpt has its marks below what they mark. *)
let scene_error ppf (e : Scene_error.t) =
  let without = { e with excerpt = ""; advice = "" } in
  let text ppf = Format.fprintf ppf "@[<hov>%a@]" Format.pp_print_text
  and verbatim ppf text =
    Format.pp_print_list Format.pp_print_string ppf
      (String.split_on_char '\n' text)
  in
  let further pp part = if part <> "" then Format.fprintf ppf "@,%a" pp part in
  Format.fprintf ppf "@[<v>%a" text
    (Format.asprintf "%a" Scene_error.pp without);
  further verbatim e.excerpt;
  further text e.advice;
  Format.fprintf ppf "@]"

let hit ppf (h : Hit.t) =
  let pp ppf h = Format.fprintf ppf "object %d, %a" h.Hit.number Hit.pp h in
  Broken.at_words pp ppf h

let event = Broken.at_words Event.pp

let events ppf events =
  let n = Seq.length events in
  Format.fprintf ppf "%d %s" n (if n = 1 then "step" else "steps")

let trace ppf t = scene ppf t.Prepared.scene

let verdict_in_box ppf : Explain.verdict -> unit = function
  | Faces_away { cosine } ->
      Format.fprintf ppf "faces away,@ cosine %a" Number.pp cosine
  | Blocked { by; t; point; _ } ->
      Format.fprintf ppf "blocked by object %d,@ t = %a@ at %a" by Number.pp t
        vec3 point
  | Outside { angle } ->
      Format.fprintf ppf "outside of its cone,@ %a degrees from the axis"
        Number.pp angle
  | Mean { points; contribution; _ } ->
      Format.fprintf ppf "the mean of %d points,@ gives %a"
        (List.length points) color contribution
  | Lit { cosine; falloff; contribution; through; _ } ->
      Format.fprintf ppf "lit,@ cosine %a,@ fall-off %a," Number.pp cosine
        Number.pp falloff;
      List.iter
        (fun { Explain.by; part; _ } ->
          Format.fprintf ppf "@ %a through object %d," Lobes.pp_factor part by)
        through;
      Format.fprintf ppf "@ gives %a" color contribution

let verdict ppf = Format.fprintf ppf "@[<hov 2>%a@]" verdict_in_box

let explain_light ppf (l : Explain.light) =
  Format.fprintf ppf "@[<hov 2>light %d:@ %a@]" l.number verdict_in_box
    l.verdict

let explain ppf e = Report.pp_with ~swatches:(Console.swatches ()) ppf e

let pixel ppf pixel =
  Report.pp_pixel_with ~swatches:(Console.swatches ()) ppf pixel

let surface_hit ppf (h : Explain.surface_hit) =
  Format.fprintf ppf "@[<v>%a@,%a@,%a" hit h.hit object_ h.object_ lobes
    h.lobes;
  List.iter (Format.fprintf ppf "@,%a" explain_light) h.lights;
  Format.fprintf ppf "@]"

let term ppf { Explain.source; color = c; _ } =
  Format.fprintf ppf "%s %a" (Event.source_name source) color c

let outcome ppf : Explain.outcome -> unit = function
  | Chain_ended -> Format.pp_print_string ppf "the chain ended: the background"
  | Too_faint ->
      Format.pp_print_string ppf "too faint to follow: the background"
  | Missed -> Format.pp_print_string ppf "nothing hit: the background"
  | Hit h -> surface_hit ppf h

let picture ppf p =
  Format.fprintf ppf "picture of %d x %d pixels" (Picture.width p)
    (Picture.height p)

let tally ppf { Tally.primary; reflected; refracted; shadow; hits; blocked; _ }
    =
  Format.fprintf ppf "@[<hov 2>%d primary,@ %d reflected" primary reflected;
  if refracted > 0 then Format.fprintf ppf ",@ %d refracted" refracted;
  Format.fprintf ppf "@ and %d shadow rays,@ %d hits,@ %d lights blocked@]"
    shadow hits blocked

open Raylab_geometry
open Raylab_scene
open Raylab_tracer

let pf = Format.fprintf
let text = Format.pp_print_text

(* [first_line ppf indent format ...] is a line, [indent] columns to the right;
   if it is broken, what follows stands further to the right. *)
let first_line ppf indent format =
  pf ppf "%s@[<hov 4>" (String.make indent ' ');
  Format.kfprintf (fun ppf -> pf ppf "@]") ppf format

let line ppf =
  pf ppf "@,";
  first_line ppf

type style = { swatches : Swatch.t; film : Film.t }

let seen film c = Film.encode film (Film.expose film c)

let color { swatches; film } ppf c =
  pf ppf "%a%a" Color.pp c (Swatch.pp_with swatches) (seen film c)

(* {1 Lights} *)

let pp_past ppf { Explain.number; object_; place } =
  pf ppf "@ past %s,@ which is shadowless"
    (Naming.by_number number object_ place)

let print_light style ppf indent { Explain.number; light; place; verdict } =
  let line format =
    line ppf indent
      ("light %d (%s%s):@ " ^^ format)
      number (Light.name light) (Naming.place place)
  in
  match verdict with
  | Lit { cosine; falloff; contribution; past; _ } ->
      line "lit%a,@ cosine %a@ * fall-off %a@ * intensity %a@ * %a@ = %a"
        (Format.pp_print_option pp_past)
        past Number.pp cosine Number.pp falloff Number.pp light.intensity
        Color.pp light.color (color style) contribution
  | Faces_away { cosine } ->
      line "the surface faces away,@ cosine %a" Number.pp cosine
  | Blocked { by; blocker; primitive; place; t; point; _ } ->
      line "blocked by %s@ at t = %a,@ point %a"
        (Naming.by_number ?primitive by blocker place)
        Number.pp t Vec3.pp point

let print_lights style ppf indent (h : Explain.surface_hit) all =
  if Color.equal h.lobes.albedo Color.black then
    line ppf indent "lights do not matter: the albedo is 0"
  else if h.lights = [] then line ppf indent "there are no lights"
  else (
    List.iter (print_light style ppf indent) h.lights;
    line ppf indent "all light: %a" (color style) all)

(* {1 Rays} *)

(* What a surface that varies is at the point, which is that of the shape before
   its modifiers. *)
let print_here ppf indent { Explain.hit; surface = here; _ } surface =
  let own ppf =
    if not (Vec3.equal hit.point hit.own_point) then
      text ppf " in its own coordinates"
  in
  let at_point sentence =
    line ppf indent "%t@ at %a%t" sentence Vec3.pp hit.own_point own
  in
  let tell pattern =
    match Pattern_text.told pattern with
    | [] -> ()
    | names -> line ppf indent "where %a" text (String.concat ", " names)
  in
  List.iter tell (Surface.patterns surface);
  match (surface : Surface.t) with
  | Checker _ -> at_point (fun ppf -> text ppf (Naming.here surface ~here))
  | _ when Surface.varies surface ->
      at_point (fun ppf ->
          pf ppf "which is %a" text (Format.asprintf "%a" Surface.pp here))
  | _ -> ()

let print_hit ppf indent (h : Explain.surface_hit) =
  let { Explain.hit; object_; primitive; place; lobes; _ } = h in
  let { Object.shape; surface; _ } = Object.primitive object_ hit.primitive in
  line ppf indent "hits %s@ at t = %a,@ point %a,@ normal %a"
    (Naming.by_number ?primitive hit.number object_ place
    |> Naming.with_part shape hit.part)
    Number.pp hit.t Vec3.pp hit.point Direction.pp hit.normal;
  line ppf indent "surface: %a" text (Format.asprintf "%a" Surface.pp surface);
  print_here ppf indent h surface;
  line ppf indent "that is, %a" Lobes.pp lobes

(* Of a term: its name, and how it came about. *)
let print_term style ppf indent sign next (h : Explain.surface_hit)
    { Explain.source; color = c; ray } =
  let line format =
    line ppf indent ("%s %-8s %a" ^^ format) sign (Event.source_name source)
      (color style) c
  in
  match (source, ray) with
  | Diffused _, _ -> line "@ = albedo * all light"
  | Mirror, Some _ ->
      line "@ = %a * colour of ray %d" Lobes.pp_factor h.lobes.mirror next
  | (Background | Emitted | Mirror), _ -> line ""

let print_sum style ppf indent number h (e : Explain.t) =
  List.iteri
    (fun i term ->
      let sign = if i = 0 then " " else "+" in
      print_term style ppf indent sign (number + 1) h term)
    e.terms;
  line ppf indent "= colour of ray %d: %a" number (color style) e.color

(* Deeper rays are not moved further to the right: there must be room left. *)
let deepest = 6

let rec print_ray style ppf number (e : Explain.t) =
  let indent = 2 * Int.min (number - 1) deepest in
  let whence = if number = 1 then "" else ", mirrored" in
  if number > 1 then pf ppf "@,";
  first_line ppf indent "ray %d%s:@ %a@ + t %a,@ %d left in the chain" number
    whence Vec3.pp (Ray.origin e.ray) Direction.pp (Ray.direction e.ray) e.left;
  let indent = indent + 2 in
  match e.outcome with
  | Chain_ended ->
      line ppf indent "the chain has ended:@ the background,@ %a" (color style)
        e.color
  | Missed ->
      line ppf indent "hits nothing:@ the background,@ %a" (color style)
        e.color
  | Hit h ->
      print_hit ppf indent h;
      print_lights style ppf indent h (Explain.light e);
      List.iter (print_ray style ppf (number + 1)) (Explain.next e);
      print_sum style ppf indent number h e

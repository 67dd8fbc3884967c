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

type style = { swatches : Swatch.t }

let color { swatches } ppf c =
  pf ppf "%a%a" Color.pp c (Swatch.pp_with swatches) c

(* {1 Lights} *)

let print_light style ppf indent { Explain.number; light; verdict } =
  let line format =
    line ppf indent
      ("light %d (%s%s):@ " ^^ format)
      number (Light.name light) (Naming.line light.line)
  in
  match verdict with
  | Lit { cosine; falloff; contribution; _ } ->
      line "lit,@ cosine %a@ * fall-off %a@ * intensity %a@ * %a@ = %a"
        Number.pp cosine Number.pp falloff Number.pp light.intensity Color.pp
        light.color (color style) contribution
  | Faces_away { cosine } ->
      line "the surface faces away,@ cosine %a" Number.pp cosine
  | Blocked { by; blocker; t; point; _ } ->
      line "blocked by %s@ at t = %a,@ point %a"
        (Naming.by_number by blocker)
        Number.pp t Vec3.pp point

let print_lights style ppf indent (h : Explain.surface_hit) =
  if Color.equal h.meaning.albedo Color.black then
    line ppf indent "lights do not matter: the albedo is 0"
  else if h.lights = [] then line ppf indent "there are no lights"
  else (
    List.iter (print_light style ppf indent) h.lights;
    line ppf indent "all light: %a" (color style) h.light)

(* {1 Rays} *)

let print_hit ppf indent { Explain.hit; object_; meaning; _ } =
  line ppf indent "hits %s@ at t = %a,@ point %a,@ normal %a"
    (Naming.by_number hit.number object_)
    Number.pp hit.t Vec3.pp hit.point Direction.pp hit.normal;
  line ppf indent "surface: %a" text
    (Format.asprintf "%a" Surface.pp object_.surface);
  line ppf indent "that is, emission %a,@ albedo %a,@ mirror %a" Color.pp
    meaning.emission Color.pp meaning.albedo Number.pp meaning.mirror

let print_sum style ppf indent number (h : Explain.surface_hit) c =
  let line format = line ppf indent format in
  line "  emitted  %a" (color style) h.emitted;
  line "+ diffused %a@ = albedo * all light" (color style) h.diffused;
  (match h.reflection with
  | None -> line "+ mirrored %a" (color style) h.mirrored
  | Some _ ->
      line "+ mirrored %a@ = %a * colour of ray %d" (color style) h.mirrored
        Number.pp h.meaning.mirror (number + 1));
  line "= colour of ray %d: %a" number (color style) c

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
      print_lights style ppf indent h;
      Option.iter (print_ray style ppf (number + 1)) h.reflection;
      print_sum style ppf indent number h e.color

(* {1 All of it} *)

let pp_summary_with ?(swatches = Swatch.None) ?pixel ppf e =
  pf ppf "@[<hov>%a:%a@ %a@]" text (Summary.subject ?pixel e)
    (Swatch.pp_with swatches) e.color text (Summary.reason e)

let pp_tree_with ?(swatches = Swatch.None) ppf e =
  pf ppf "@[<v>";
  print_ray { swatches } ppf 1 e;
  pf ppf "@]"

let pp_with ?swatches ?pixel ppf e =
  pf ppf "@[<v>%a@,@,%a@]"
    (pp_summary_with ?swatches ?pixel)
    e (pp_tree_with ?swatches) e

let pp ppf e = pp_with ppf e
let pp_summary ppf e = pp_summary_with ppf e
let pp_tree ppf e = pp_tree_with ppf e

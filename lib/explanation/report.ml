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

let print_light style ppf indent { Explain.number; light; place; verdict } =
  let line format =
    line ppf indent
      ("light %d (%s%s):@ " ^^ format)
      number (Light.name light) (Naming.place place)
  in
  match verdict with
  | Lit { cosine; falloff; contribution; _ } ->
      line "lit,@ cosine %a@ * fall-off %a@ * intensity %a@ * %a@ = %a"
        Number.pp cosine Number.pp falloff Number.pp light.intensity Color.pp
        light.color (color style) contribution
  | Faces_away { cosine } ->
      line "the surface faces away,@ cosine %a" Number.pp cosine
  | Blocked { by; blocker; place; t; point; _ } ->
      line "blocked by %s@ at t = %a,@ point %a"
        (Naming.by_number by blocker place)
        Number.pp t Vec3.pp point

let print_lights style ppf indent (h : Explain.surface_hit) all =
  if Color.equal h.lobes.albedo Color.black then
    line ppf indent "lights do not matter: the albedo is 0"
  else if h.lights = [] then line ppf indent "there are no lights"
  else (
    List.iter (print_light style ppf indent) h.lights;
    line ppf indent "all light: %a" (color style) all)

(* {1 Rays} *)

let print_hit ppf indent { Explain.hit; object_; place; lobes; _ } =
  line ppf indent "hits %s@ at t = %a,@ point %a,@ normal %a"
    (Naming.by_number hit.number object_ place
    |> Naming.with_part object_.shape hit.part)
    Number.pp hit.t Vec3.pp hit.point Direction.pp hit.normal;
  line ppf indent "surface: %a" text
    (Format.asprintf "%a" Surface.pp object_.surface);
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

(* {1 All of a ray} *)

let style ?(swatches = Swatch.None) ?(film = Film.default) () =
  { swatches; film }

let print_summary { swatches; _ } ppf subject shown reason =
  pf ppf "@[<hov>%a:%a@ %a@]" text subject (Swatch.pp_with swatches) shown text
    reason

let pp_summary_with ?swatches ppf (e : Explain.t) =
  print_summary (style ?swatches ()) ppf (Summary.subject e) e.color
    (Reason.of_ray Film.default e)

let print_tree style ppf e =
  pf ppf "@[<v>";
  print_ray style ppf 1 e;
  pf ppf "@]"

let pp_tree_with ?swatches ppf e = print_tree (style ?swatches ()) ppf e

let pp_with ?swatches ppf e =
  pf ppf "@[<v>%a@,@,%a@]"
    (pp_summary_with ?swatches)
    e (pp_tree_with ?swatches) e

let pp ppf e = pp_with ppf e
let pp_summary ppf e = pp_summary_with ppf e
let pp_tree ppf e = pp_tree_with ppf e

(* {1 Pixels} *)

let style_of ?swatches { Explain.film; _ } = style ?swatches ~film ()

let pp_pixel_summary_with ?swatches ppf (pixel : Explain.pixel) =
  print_summary (style_of ?swatches pixel) ppf
    (Summary.pixel_subject pixel)
    (Film.encode pixel.film pixel.color)
    (Summary.pixel_reason pixel)

(* What a sample adds to the mean, where it is not just the ray's colour. *)
let print_exposed style ppf { Explain.color = c; ray } =
  if not (Color.equal c ray.color) then
    line ppf 0 "times the exposure %a,@ brought into 0 to 1: %a" Number.pp
      style.film.exposure Color.pp c

let print_encoded style ppf c =
  if style.film.srgb then
    line ppf 0 "shown by the sRGB curve as %a" Color.pp
      (Film.encode style.film c)

let print_cause ppf { Explain.samples; cause; film; _ } =
  let centre = (List.hd samples).Explain.color in
  let { Sampler.x; y; color = c } = Option.get cause in
  first_line ppf 0
    "%d samples, of at most %d,@ since the centre is %a@ and that of pixel@ \
     (%d, %d)@ is %a%s"
    (List.length samples) film.samples Color.pp centre x y Color.pp c
    (if film.srgb then ", before the sRGB curve" else "")

let print_sample style ppf pixel number sample =
  let is_in group = List.mem number group.Group.numbers in
  let group = List.find is_in (Group.of_pixel pixel) in
  first_line ppf 0 "sample %d,@ %s@ %a:" number
    (match Group.size group with
    | 1 -> "which alone sees"
    | n -> Printf.sprintf "one of %d that see" n)
    text group.sees;
  pf ppf "@,";
  print_ray style ppf 1 sample.Explain.ray;
  print_exposed style ppf sample

let print_mean style ppf { Explain.samples; color = c; _ } =
  let add sum ({ color; _ } : Explain.sample) = Color.add sum color in
  let sum = List.fold_left add Color.black samples in
  first_line ppf 0 "sum of all %d samples:@ %a" (List.length samples) Color.pp
    sum;
  line ppf 0 "divided by their number = colour of the pixel:@ %a" (color style)
    c;
  print_encoded style ppf c

let print_one style ppf { Explain.samples; color; _ } =
  let sample = List.hd samples in
  print_ray style ppf 1 sample.Explain.ray;
  print_exposed style ppf sample;
  print_encoded style ppf color

let print_several style ppf (pixel : Explain.pixel) =
  print_cause ppf pixel;
  List.iter
    (fun { Group.numbers; sample; _ } ->
      pf ppf "@,@,";
      print_sample style ppf pixel (List.hd numbers) sample)
    (Group.of_pixel pixel);
  pf ppf "@,@,";
  print_mean style ppf pixel

let pp_pixel_with ?swatches ?sample ppf (pixel : Explain.pixel) =
  let style = style_of ?swatches pixel in
  pf ppf "@[<v>%a@,@," (pp_pixel_summary_with ?swatches) pixel;
  (match (sample, pixel.samples) with
  | None, [ _ ] -> print_one style ppf pixel
  | None, _ -> print_several style ppf pixel
  | Some k, samples ->
      print_sample style ppf pixel k (List.nth samples (k - 1)));
  pf ppf "@]"

let pp_pixel ppf pixel = pp_pixel_with ppf pixel

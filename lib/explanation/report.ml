open Raylab_geometry
open Raylab_scene
open Raylab_tracer

let pf = Format.fprintf
let text = Format.pp_print_text

(* {1 All of a ray} *)

let style ?(swatches = Swatch.None) ?(film = Film.default) () =
  { Tree.swatches; film }

let print_summary { Tree.swatches; _ } ppf subject shown reason =
  pf ppf "@[<hov>%a:%a@ %a@]" text subject (Swatch.pp_with swatches) shown text
    reason

let pp_summary_with ?swatches ppf (e : Explain.t) =
  print_summary (style ?swatches ()) ppf (Summary.subject e) e.color
    (Reason.of_ray Film.default e)

let print_tree style ppf e =
  pf ppf "@[<v>";
  Tree.print_ray style ppf e;
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
    Tree.line ppf 0 "times the exposure %a,@ brought into 0 to 1: %a" Number.pp
      style.Tree.film.exposure Color.pp c

let print_encoded style ppf c =
  if style.Tree.film.srgb then
    Tree.line ppf 0 "shown by the sRGB curve as %a" Color.pp
      (Film.encode style.Tree.film c)

let print_cause ppf { Explain.samples; cause; film; _ } =
  let centre = (List.hd samples).Explain.color in
  let { Centres.x; y; color = c } = Option.get cause in
  Tree.first_line ppf 0
    "%d samples, of at most %d,@ since the centre is %a@ and that of pixel@ \
     (%d, %d)@ is %a%s"
    (List.length samples) film.samples Color.pp centre x y Color.pp c
    (if film.srgb then ", before the sRGB curve" else "")

let print_sample style ppf group number sample =
  Tree.first_line ppf 0 "sample %d,@ %s@ %a:" number
    (match Group.size group with
    | 1 -> "which alone sees"
    | n -> Printf.sprintf "one of %d that see" n)
    text group.Group.sees;
  pf ppf "@,";
  Tree.print_ray style ppf sample.Explain.ray;
  print_exposed style ppf sample

let print_mean style ppf { Explain.samples; color = c; _ } =
  let add sum ({ color; _ } : Explain.sample) = Color.add sum color in
  let sum = List.fold_left add Color.black samples in
  Tree.first_line ppf 0 "sum of all %d samples:@ %a" (List.length samples)
    Color.pp sum;
  Tree.line ppf 0 "divided by their number = colour of the pixel:@ %a"
    (Tree.color style) c;
  print_encoded style ppf c

let print_one style ppf { Explain.samples; color; _ } =
  let sample = List.hd samples in
  Tree.print_ray style ppf sample.Explain.ray;
  print_exposed style ppf sample;
  print_encoded style ppf color

let print_several style ppf (pixel : Explain.pixel) =
  print_cause ppf pixel;
  List.iter
    (fun ({ Group.numbers; sample; _ } as group) ->
      pf ppf "@,@,";
      print_sample style ppf group (List.hd numbers) sample)
    (Group.of_pixel pixel);
  pf ppf "@,@,";
  print_mean style ppf pixel

let print_numbered style ppf (pixel : Explain.pixel) number =
  let is_in group = List.mem number group.Group.numbers in
  let group = List.find is_in (Group.of_pixel pixel) in
  print_sample style ppf group number (List.nth pixel.samples (number - 1))

let pp_pixel_with ?swatches ?sample ppf (pixel : Explain.pixel) =
  let style = style_of ?swatches pixel in
  pf ppf "@[<v>%a@,@," (pp_pixel_summary_with ?swatches) pixel;
  (match (sample, pixel.samples) with
  | Some number, _ -> print_numbered style ppf pixel number
  | None, [ _ ] -> print_one style ppf pixel
  | None, _ -> print_several style ppf pixel);
  pf ppf "@]"

let pp_pixel ppf pixel = pp_pixel_with ppf pixel

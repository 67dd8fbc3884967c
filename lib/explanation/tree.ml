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

let pp_crossed ppf { Explain.by; object_; primitive; place; part; _ } =
  pf ppf "@ * %a@ through %s" Lobes.pp_factor part
    (Naming.by_number ?primitive by object_ place)

let pp_cone ppf { Event.angle; part } =
  pf ppf "@ * cone %a@ (%a degrees from the axis)" Number.pp part Number.pp
    angle

let sum_of_points points =
  let add sum : Explain.verdict -> Color.t = function
    | Lit { contribution; _ } -> Color.add sum contribution
    | Faces_away _ | Outside _ | Blocked _ | Mean _ -> sum
  in
  List.fold_left add Color.black points

(* What it gives to each highlight, if it is not nothing. *)
let print_shines style ppf indent (h : Explain.surface_hit) shines =
  let print { Lobes.sharpness; _ } shine =
    if not (Color.equal shine Color.black) then
      line ppf (indent + 4) "to the highlight of sharpness %a:@ %a" Number.pp
        sharpness (color style) shine
  in
  List.iter2 print h.lobes.highlights shines

let print_light style ppf indent h { Explain.number; light; place; verdict } =
  let line format =
    line ppf indent
      ("light %d (%s%s):@ " ^^ format)
      number (Light.name light) (Naming.place place)
  in
  match verdict with
  | Lit { cosine; falloff; cone; contribution; shines; past; through; _ } ->
      line "lit%a,@ cosine %a@ * fall-off %a%a@ * intensity %a@ * %a%a@ = %a"
        (Format.pp_print_option pp_past)
        past Number.pp cosine Number.pp falloff
        (Format.pp_print_option pp_cone)
        cone Number.pp light.intensity Color.pp light.color
        (Format.pp_print_list ~pp_sep:(fun _ () -> ()) pp_crossed)
        through (color style) contribution;
      print_shines style ppf indent h shines
  | Outside { angle } ->
      line "the surface is outside of the cone,@ %a degrees from the axis"
        Number.pp angle
  | Mean { points; contribution; shines } ->
      let part = Points_seen.make points in
      if part.seen = 0 then line "%a" text (Points_seen.to_string part)
      else (
        line "%a:@ together they give %a,@ divided by %d@ = %a" text
          (Points_seen.to_string part)
          Color.pp (sum_of_points points) part.points (color style)
          contribution;
        print_shines style ppf indent h shines)
  | Faces_away { cosine } ->
      line "the surface faces away,@ cosine %a" Number.pp cosine
  | Blocked { by; blocker; primitive; place; t; point; _ } ->
      line "blocked by %s@ at t = %a,@ point %a"
        (Naming.by_number ?primitive by blocker place)
        Number.pp t Vec3.pp point

let print_lights style ppf indent (h : Explain.surface_hit) ~ambient all =
  let is_dark = Color.equal ambient Color.black in
  if Color.equal h.lobes.albedo Color.black && h.lobes.highlights = [] then
    line ppf indent "lights do not matter: the albedo is 0"
  else if h.lights = [] && is_dark then line ppf indent "there are no lights"
  else (
    if not is_dark then line ppf indent "ambient light: %a" Color.pp ambient;
    List.iter (print_light style ppf indent h) h.lights;
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

let print_hit ppf indent e (h : Explain.surface_hit) =
  let { Explain.hit; object_; primitive; place; lobes; _ } = h in
  let { Object.shape; surface; _ } = Object.primitive object_ hit.primitive in
  line ppf indent "hits %a@ at t = %a,@ point %a,@ normal %a" text
    (Naming.by_number ?primitive hit.number object_ place
    |> Naming.with_part shape hit.part)
    Number.pp hit.t Vec3.pp hit.point Hit.pp_normal hit;
  line ppf indent "surface: %a" text (Format.asprintf "%a" Surface.pp surface);
  print_here ppf indent h surface;
  line ppf indent "that is, %a" Lobes.pp lobes;
  let say words = line ppf indent "%a" text words in
  List.iter say (Bending.of_hit e h)

(* Of a term: its name, and how it came about, with the number of its ray. *)
let print_term style ppf indent sign ({ Explain.source; color = c; _ }, next) =
  let line format =
    line ppf indent ("%s %-8s %a" ^^ format) sign (Event.source_name source)
      (color style) c
  in
  match (source, next) with
  | Diffused _, _ -> line "@ = albedo * all light"
  | Shine { sharpness; shine }, _ ->
      line "@ = highlight of sharpness %a@ * all that shines, %a" Number.pp
        sharpness Color.pp shine
  | (Mirror { weight } | Refraction { weight; _ }), Some next ->
      line "@ @[<hov 2>= %a@ * colour of ray %d@]" Lobes.pp_factor weight next
  | (Background | Emitted | Mirror _ | Refraction _), _ -> line ""

let print_sum style ppf indent number terms (e : Explain.t) =
  List.iteri
    (fun i term ->
      let sign = if i = 0 then " " else "+" in
      print_term style ppf indent sign term)
    terms;
  line ppf indent "= colour of ray %d: %a" number (color style) e.color

(* Deeper rays are not moved further to the right: there must be room left. *)
let deepest = 6

(* Prints the ray of this number, which others were sent on to [depth] times,
   and those after it, and is the last number of them all. *)
let rec print style ppf ~depth ~whence number (e : Explain.t) =
  let indent = 2 * Int.min depth deepest in
  if number > 1 then pf ppf "@,";
  first_line ppf indent "ray %d%a:@ %a@ + t %a,@ %d left in the chain" number
    text whence Vec3.pp (Ray.origin e.ray) Direction.pp (Ray.direction e.ray)
    e.left;
  let indent = indent + 2 in
  let background why =
    line ppf indent "%s:@ the background,@ %a" why (color style) e.color;
    number
  in
  match e.outcome with
  | Chain_ended -> background "the chain has ended"
  | Too_faint -> background "too faint to follow"
  | Missed -> background "hits nothing"
  | Hit h ->
      print_hit ppf indent e h;
      print_lights style ppf indent h ~ambient:(Explain.ambient e)
        (Explain.light e);
      let term last (term : Explain.term) =
        let print next =
          let whence = Bending.whence e next in
          print style ppf ~depth:(depth + 1) ~whence (last + 1) next
        in
        ( Option.fold ~none:last ~some:print term.ray,
          (term, Option.map (fun _ -> last + 1) term.ray) )
      in
      let last, terms = List.fold_left_map term number e.terms in
      print_sum style ppf indent number terms e;
      last

let print_ray style ppf e =
  ignore (print style ppf ~depth:0 ~whence:"" 1 e : int)

open Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Test_support

let is_same a b =
  let bits x = Int64.bits_of_float (x +. 0.) in
  let same x y = Int64.equal (bits x) (bits y) in
  same a.Color.r b.Color.r && same a.g b.g && same a.b b.b

let limited f = Saturate.color f
let sum a b = limited (Color.add a b)

let contribution { Explain.verdict; _ } =
  match verdict with
  | Lit { contribution; _ } -> contribution
  | Faces_away _ | Blocked _ -> Color.black

(* From the left, and limited only at the end. *)
let total terms =
  let add sum (term : Explain.term) = Color.add sum term.color in
  match terms with
  | [] -> Color.black
  | (first : Explain.term) :: rest ->
      limited (List.fold_left add first.color rest)

(* A colour is what its source makes of the lobes, the lights and the ray. *)
let term_is_right (h : Explain.surface_hit) (term : Explain.term) =
  let { Lobes.emission; albedo; mirror; _ } = h.lobes in
  match (term.source, term.ray) with
  | Emitted, None -> is_same term.color emission
  | Diffused { light }, None ->
      let lights = List.map contribution h.lights in
      is_same light (List.fold_left sum Color.black lights)
      && is_same term.color (limited (Color.multiply albedo light))
  | Mirror, None -> Color.largest mirror = 0. && is_same term.color Color.black
  | Mirror, Some next ->
      Color.largest mirror > 0.
      && is_same term.color (limited (Color.multiply mirror next.color))
  | Background, _ | (Emitted | Diffused _), Some _ -> false

let sources (e : Explain.t) =
  List.map (fun (term : Explain.term) -> Event.source_name term.source) e.terms

let rec adds_up background (e : Explain.t) =
  is_same e.color (total e.terms)
  &&
  match e.outcome with
  | Missed | Chain_ended ->
      (e.outcome = Missed || e.left = 0)
      && sources e = [ "background" ]
      && is_same e.color
           (Background.at background (Ray.direction e.ray :> Vec3.t))
  | Hit h ->
      sources e = [ "emitted"; "diffused"; "mirrored" ]
      && List.for_all (term_is_right h) e.terms
      && List.for_all
           (fun (next : Explain.t) ->
             next.role = Mirrored
             && next.left = e.left - 1
             && adds_up background next)
           (Explain.next e)

(* Added from the left, and divided by their number. *)
let mean = function
  | [] -> Color.black
  | ({ color; _ } : Explain.sample) :: rest as samples ->
      let add sum ({ color; _ } : Explain.sample) = Color.add sum color in
      let { Color.r; g; b } = List.fold_left add color rest
      and n = float_of_int (List.length samples) in
      Color.make (r /. n) (g /. n) (b /. n)

let exposed { Film.exposure; _ } { Color.r; g; b } =
  let channel v = Float.min 1. (exposure *. v) in
  Color.make (channel r) (channel g) (channel b)

let pixel_is_right scene { Explain.x; y; film; samples; cause; color } =
  let sample { Explain.color; ray } = is_same color (exposed film ray.color) in
  is_same color (Tracer.pixel scene ~x ~y)
  && is_same color (mean samples)
  && List.for_all sample samples
  && List.length samples <= film.samples
  && Option.is_some cause = (List.length samples > 1)

let pixels =
  Any.holds "samples are the colour of their ray, and the pixel their mean"
    (fun scene -> List.for_all (pixel_is_right scene) (Any.explained scene))

let sums =
  Any.holds "the parts add up to the whole" (fun scene ->
      let { Scene.background; _ } = scene.Prepared.scene in
      let sample { Explain.ray; _ } = adds_up background ray in
      let pixel { Explain.samples; _ } = List.for_all sample samples in
      List.for_all pixel (Any.explained scene))

(* {1 Numbers of rays} *)

let count (tally : Tally.t) (e : Explain.t) =
  let light { Explain.verdict; _ } =
    match verdict with
    | Faces_away _ | Lit { shadow_ray = None; _ } -> ()
    | Lit { shadow_ray = Some _; _ } -> tally.shadow <- tally.shadow + 1
    | Blocked _ ->
        tally.shadow <- tally.shadow + 1;
        tally.blocked <- tally.blocked + 1
  in
  let rec ray (e : Explain.t) =
    match e.outcome with
    | Missed | Chain_ended -> ()
    | Hit h ->
        tally.hits <- tally.hits + 1;
        List.iter light h.lights;
        let follow (next : Explain.t) =
          if next.outcome <> Chain_ended then
            tally.reflected <- tally.reflected + 1;
          ray next
        in
        List.iter follow (Explain.next e)
  in
  tally.primary <- tally.primary + 1;
  ray e

let tally =
  Any.holds "as many rays as the rendering counts" ~max_side:12 (fun scene ->
      let scene = scene.Prepared.scene in
      let film = Film.with_samples 1 scene.film in
      let scene = Prepared.make (Scene.with_film film scene) in
      let counted = Tally.create () in
      let pixel { Explain.samples; _ } =
        let { Explain.ray; _ } = List.hd samples in
        count counted ray;
        counted.samples <- counted.samples + 1;
        if Film.over_exposed film ray.color then
          counted.over_exposed <- counted.over_exposed + 1
      in
      List.iter pixel (Any.explained scene);
      counted = snd (Render.picture ~domains:1 scene))

let suite = ("Parts", pixels @ sums @ tally)

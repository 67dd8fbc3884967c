module Geometry = Raylab_geometry
open Raylab_scene
open Raylab_tracer
open Test_support

let is_same a b =
  let bits x = Int64.bits_of_float (x +. 0.) in
  let same x y = Int64.equal (bits x) (bits y) in
  same a.Color.r b.Color.r && same a.g b.g && same a.b b.b

let limited f = Saturate.color f
let sum a b = limited (Color.add a b)

let divided { Color.r; g; b } n =
  let n = float_of_int n in
  Color.make (r /. n) (g /. n) (b /. n)

let rec contribution : Explain.verdict -> Color.t = function
  | Lit { contribution; _ } -> contribution
  | Faces_away _ | Outside _ | Blocked _ -> Color.black
  | Mean { points; _ } ->
      let all = List.map contribution points in
      divided (List.fold_left sum Color.black all) (List.length points)

(* What a light gives to highlight [k]. *)
let rec shine k : Explain.verdict -> Color.t = function
  | Lit { shines; _ } -> List.nth shines k
  | Faces_away _ | Outside _ | Blocked _ -> Color.black
  | Mean { points; _ } ->
      let all = List.map (shine k) points in
      divided (List.fold_left sum Color.black all) (List.length points)

let rec is_mean : Explain.verdict -> bool = function
  | Mean { points; contribution = c; shines } as verdict ->
      let is_shine k s = is_same s (shine k verdict) in
      is_same c (contribution verdict)
      && List.for_all Fun.id (List.mapi is_shine shines)
      && List.for_all is_mean points
  | Lit _ | Faces_away _ | Outside _ | Blocked _ -> true

(* cosine * fall-off * intensity * colour, and what is left of that behind all
   that the light goes through. *)
let rec gift_is_right (light : Light.t) (verdict : Explain.verdict) =
  match verdict with
  | Faces_away _ | Outside _ | Blocked _ -> true
  | Mean { points; _ } -> List.for_all (gift_is_right light) points
  | Lit { cosine; falloff; cone; contribution; through; _ } ->
      let part =
        Option.fold cone ~none:1. ~some:(fun { Event.part; _ } -> part)
      in
      let k = Saturate.limit (cosine *. falloff) *. part in
      let gives = limited (Color.scale k light.power) in
      let weaken tint { Explain.part; _ } =
        limited (Color.multiply tint part)
      in
      let tint = List.fold_left weaken Color.white through in
      is_same contribution (limited (Color.multiply gives tint))

(* From the left, and limited only at the end. *)
let total terms =
  let add sum (term : Explain.term) = Color.add sum term.color in
  match terms with
  | [] -> Color.black
  | (first : Explain.term) :: rest ->
      limited (List.fold_left add first.color rest)

(* What [f] makes of each of the refractions, and how it is here: Fresnel's
   share, and whether it is totally reflected. *)
let bent f { Lobes.refractions; _ } terms =
  let share (term : Explain.term) =
    match term.source with
    | Refraction { index; share; cosine; _ } -> Some (index, share, cosine = 0.)
    | _ -> None
  in
  List.map2
    (fun (r : Lobes.refraction) (index, share, is_total) ->
      if r.index <> index then invalid_arg "another refraction";
      f r share is_total)
    refractions
    (List.filter_map share terms)

(* Fresnel's share of glass, and all of what is totally reflected. *)
let mirrored lobes terms =
  let add mirror (r : Lobes.refraction) share is_total =
    let of_glass = Color.scale share r.fresnel
    and of_plain = Color.scale (if is_total then 1. else 0.) r.plain in
    limited (Color.add mirror (Color.add of_glass of_plain))
  in
  List.fold_left
    (fun mirror add -> add mirror)
    lobes.Lobes.mirror
    (bent (fun r share total mirror -> add mirror r share total) lobes terms)

let refracted lobes (term : Explain.term) =
  match term.source with
  | Refraction { index; share; cosine; _ } ->
      let is_it { Lobes.index = i; _ } = i = index in
      let r = List.find is_it lobes.Lobes.refractions in
      let plain = if cosine = 0. then Color.black else r.plain in
      limited (Color.add plain (Color.scale (1. -. share) r.glass))
  | _ -> Color.black

(* A ray that is sent on has its part of the share of the one before. *)
let shares_are_right (e : Explain.t) =
  let weights =
    List.filter_map
      (fun (term : Explain.term) ->
        match term.source with
        | Mirror { weight } | Refraction { weight; _ } ->
            Some (Color.largest weight, term.ray)
        | Background | Emitted | Diffused _ | Shine _ -> None)
      e.terms
  in
  let sum = List.fold_left (fun sum (w, _) -> sum +. w) 0. weights in
  let own = Geometry.Ray.share e.ray in
  let is_alone = List.length (Explain.next e) = 1 in
  List.for_all
    (fun (w, ray) ->
      match ray with
      | None -> true
      | Some (next : Explain.t) ->
          let expected =
            if is_alone then own
            else own *. (w /. Saturate.limit (Float.max 1. sum))
          in
          Geometry.Ray.share next.ray = expected)
    weights

(* A colour is what its source makes of the lobes, the lights and the ray. *)
let term_is_right terms (h : Explain.surface_hit) (term : Explain.term) =
  let { Lobes.emission; albedo; _ } = h.lobes in
  let of_ray weight ray =
    match ray with
    | None -> Color.largest weight = 0. && is_same term.color Color.black
    | Some (next : Explain.t) ->
        Color.largest weight > 0.
        && is_same term.color (limited (Color.multiply weight next.color))
  in
  match (term.source, term.ray) with
  | Emitted, None -> is_same term.color emission
  | Diffused { ambient; light }, None ->
      let verdicts = List.map (fun l -> l.Explain.verdict) h.lights in
      let lights = List.map contribution verdicts in
      is_same light (List.fold_left sum ambient lights)
      && List.for_all is_mean verdicts
      && is_same term.color (limited (Color.multiply albedo light))
  | Shine { sharpness; shine = s }, None ->
      let is_it (_, h) = h.Lobes.sharpness = sharpness in
      let numbered = List.mapi (fun k h -> (k, h)) h.lobes.highlights in
      let k, { Lobes.shine = color; _ } = List.find is_it numbered in
      let gives l = shine k l.Explain.verdict in
      is_same s (List.fold_left sum Color.black (List.map gives h.lights))
      && is_same term.color (limited (Color.multiply color s))
  | Mirror { weight }, ray ->
      is_same weight (mirrored h.lobes terms) && of_ray weight ray
  | Refraction { weight; _ }, ray ->
      is_same weight (refracted h.lobes term) && of_ray weight ray
  | Background, _ | (Emitted | Diffused _ | Shine _), Some _ -> false

let sources (e : Explain.t) =
  List.map (fun (term : Explain.term) -> Event.source_name term.source) e.terms

let rec adds_up background (e : Explain.t) =
  is_same e.color (total e.terms)
  &&
  match e.outcome with
  | Missed | Chain_ended | Too_faint ->
      (e.outcome <> Chain_ended || e.left = 0)
      && (e.outcome <> Too_faint || Geometry.Ray.share e.ray < 1. /. 1024.)
      && sources e = [ "background" ]
      && is_same e.color
           (Background.at background
              (Geometry.Ray.direction e.ray :> Geometry.Vec3.t))
  | Hit h ->
      sources e
      = [ "emitted"; "diffused" ]
        @ List.map (fun _ -> "shine") h.lobes.highlights
        @ [ "mirrored" ]
        @ List.map (fun _ -> "refracted") h.lobes.refractions
      && List.for_all (term_is_right e.terms h) e.terms
      && List.for_all
           (fun (l : Explain.light) -> gift_is_right l.light l.verdict)
           h.lights
      && Geometry.Ray.share e.ray >= 1. /. 1024.
      && shares_are_right e
      && List.for_all
           (fun (next : Explain.t) ->
             next.role <> Primary
             && next.left = e.left - 1
             && adds_up background next)
           (Explain.next e)

(* Added from the left, and divided by their number. *)
let mean = function
  | [] -> Color.black
  | ({ color; _ } : Explain.sample) :: rest as samples ->
      let add sum ({ color; _ } : Explain.sample) = Color.add sum color in
      divided (List.fold_left add color rest) (List.length samples)

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
  let rec verdict : Explain.verdict -> unit = function
    | Faces_away _ | Outside _ | Lit { shadow_ray = None; _ } -> ()
    | Mean { points; _ } -> List.iter verdict points
    | Lit { shadow_ray = Some _; _ } -> tally.shadow <- tally.shadow + 1
    | Blocked _ ->
        tally.shadow <- tally.shadow + 1;
        tally.blocked <- tally.blocked + 1
  in
  let rec ray (e : Explain.t) =
    match e.outcome with
    | Missed | Chain_ended | Too_faint -> ()
    | Hit h ->
        tally.hits <- tally.hits + 1;
        List.iter (fun l -> verdict l.Explain.verdict) h.lights;
        let follow (next : Explain.t) =
          (match (next.outcome, next.role) with
          | (Chain_ended | Too_faint), _ | _, Primary -> ()
          | _, Mirrored -> tally.reflected <- tally.reflected + 1
          | _, Refracted -> tally.refracted <- tally.refracted + 1);
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

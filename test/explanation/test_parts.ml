open Raylab_scene
open Raylab_tracer

let is_same a b =
  let bits x = Int64.bits_of_float (x +. 0.) in
  let same x y = Int64.equal (bits x) (bits y) in
  same a.Color.r b.Color.r && same a.g b.g && same a.b b.b

let limited f = Saturate.color f
let sum a b = limited (Color.add a b)

(* From the left, and limited only at the end. *)
let sum_of_three a b c = limited (Color.add (Color.add a b) c)

let contribution { Explain.verdict; _ } =
  match verdict with
  | Lit { contribution; _ } -> contribution
  | Faces_away _ | Blocked _ -> Color.black

let hit_adds_up (h : Explain.surface_hit) color =
  let { Surface.emission; albedo; mirror } = h.meaning in
  let light =
    List.fold_left sum Color.black (List.map contribution h.lights)
  in
  let seen =
    match h.reflection with
    | None -> Color.black
    | Some next -> Color.scale mirror next.color
  in
  is_same h.light light && is_same h.emitted emission
  && is_same h.diffused (limited (Color.multiply albedo h.light))
  && is_same h.mirrored (limited seen)
  && Option.is_some h.reflection = (mirror > 0.)
  && is_same color (sum_of_three h.emitted h.diffused h.mirrored)

let rec adds_up background (e : Explain.t) =
  match e.outcome with
  | Missed -> is_same e.color background
  | Chain_ended -> e.left = 0 && is_same e.color background
  | Hit h -> (
      hit_adds_up h e.color
      &&
      match h.reflection with
      | None -> true
      | Some next -> next.left = e.left - 1 && adds_up background next)

let root =
  Any.holds "the root has the pixel's colour" (fun scene ->
      List.for_all
        (fun ((x, y), (e : Explain.t)) ->
          is_same e.color (Trace.pixel scene ~x ~y))
        (Any.explanations scene))

let sums =
  Any.holds "the parts add up to the whole" (fun scene ->
      let { Scene.background; _ } = Trace.scene scene in
      List.for_all
        (fun (_, e) -> adds_up background e)
        (Any.explanations scene))

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
        Option.iter follow h.reflection
  in
  tally.primary <- tally.primary + 1;
  ray e

let tally =
  Any.holds "as many rays as the rendering counts" ~max_side:12 (fun scene ->
      let counted = Tally.create () in
      List.iter (fun (_, e) -> count counted e) (Any.explanations scene);
      counted = snd (Render.picture ~domains:1 scene))

let suite = ("Parts", root @ sums @ tally)

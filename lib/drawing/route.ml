open Raylab_geometry
open Raylab_scene
open Raylab_tracer

let pf = Printf.sprintf
let most = 200

(* Shorter lines have no room for an arrow head and a number. *)
let shortest = 30.

(* An arrow head in the middle of a line. *)
let arrow kind ((x, y) as a) ((x', y') as b) =
  let length, ((ux, uy) as u) = Stroke.way a b in
  let tip =
    (((x +. x') /. 2.) +. (6. *. ux), ((y +. y') /. 2.) +. (6. *. uy))
  in
  if length < shortest then [] else [ Stroke.head (Stroke.ink kind) tip u ]

(* The number of a ray, beside its middle or as near to that as there is room.
   Farther from the ray it might be taken for that of another. *)
let number kind k ((x, y) as a) b =
  let length, (ux, uy) = Stroke.way a b in
  let place part aside =
    let along = part *. length in
    ( x +. (along *. ux) -. (aside *. uy),
      y +. (along *. uy) +. (aside *. ux) +. 4. )
  in
  let places =
    List.concat_map
      (fun part -> [ place part 13.; place part (-13.) ])
      [ 0.5; 0.4; 0.6; 0.3; 0.7; 0.2; 0.8 ]
  in
  if length < shortest then []
  else
    [
      Label.make ~anchor:"middle" ~color:(Stroke.ink kind) ~reach:0. places
        (string_of_int k);
    ]

let destination { Path.kind; length; meets; _ } =
  match (kind, meets) with
  | (Primary | Mirrored), None -> "to the background"
  | (Primary | Mirrored), Some (number, (o : Object.t)) ->
      Format.asprintf "to %s %d, t = %a" (Shape.name o.shape) number Number.pp
        length
  | Unfollowed, _ -> "the chain has ended"
  | Lit light, _ when length = infinity -> pf "light %d" light
  | Lit light, _ -> pf "to light %d" light
  | Blocked _, Some (number, o) ->
      pf "blocked by %s %d" (Shape.name o.shape) number
  | Blocked _, None -> ""

(* What stands at the edge, where a ray from [a] leaves the panel at [b]. *)
let leaving (view : View.t) (line : Path.line) a ((x, y) as b) =
  let is_left = x < view.left +. (view.width /. 2.) in
  let anchor = if is_left then "start" else "end" in
  let color = Stroke.ink line.kind in
  let place = ((if is_left then x +. 12. else x -. 12.), y +. 14.) in
  let label =
    Drawn.label
      (Label.make ~anchor ~size:11. ~color [ place ] (destination line))
  in
  match line.kind with
  | Lit _ when line.length = infinity ->
      (* this is where the light comes in *)
      let _, ((ux, uy) as inwards) = Stroke.way b a in
      let along k = (x +. (k *. ux), y +. (k *. uy)) in
      Drawn.all
        [
          Drawn.mark
            (Rectangle.around (along 16.) 8.)
            [ Stroke.head color (along 22.) inwards ];
          label;
        ]
  | _ -> label

(* A ray that is not followed is only a stub. *)
let stub = 45.

let draw_line (view : View.t) k (line : Path.line) =
  let origin = Ray.origin line.ray
  and direction = (Ray.direction line.ray :> Vec3.t) in
  let length =
    if line.kind = Unfollowed then stub /. view.scale else line.length
  in
  match View.segment view origin direction length with
  | None -> Drawn.all []
  | Some (a, b) ->
      let ends_inside =
        Float.is_finite length
        && View.contains view (View.point view (Ray.at line.ray length))
      in
      let decoration =
        match line.kind with
        | Primary | Mirrored ->
            [
              Drawn.shapes (arrow line.kind a b);
              Drawn.all (List.map Drawn.label (number line.kind k a b));
            ]
        | Blocked _ ->
            if ends_inside then
              [ Drawn.mark (Rectangle.around b 6.) (Stroke.cross b) ]
            else []
        | Lit _ -> []
        | Unfollowed -> [ leaving view line a b ]
      in
      Drawn.all
        (Drawn.shapes [ Svg.line ~style:(Stroke.style line.kind) a b ]
         :: decoration
        @ if ends_inside then [] else [ leaving view line a b ])

let directional_lights e =
  List.filter_map
    (fun (line : Path.line) ->
      match line.kind with
      | Lit light when line.length = infinity -> Some light
      | _ -> None)
    (Path.lines e)

let dot view ((h : Explain.surface_hit), color) =
  let r, g, b = Color.to_bytes color in
  let place = View.point view h.hit.point in
  let style =
    pf {|fill="rgb(%d,%d,%d)" stroke="#222" stroke-width="1.2"|} r g b
  in
  if View.contains view place then
    Drawn.mark (Rectangle.around place 5.) [ Svg.circle ~style place 4. ]
  else Drawn.all []

let draw view e =
  let shown items = List.filteri (fun i _ -> i < most) items in
  let count k (line : Path.line) =
    match line.kind with
    | Lit _ | Blocked _ -> (k, (k, line))
    | Primary | Mirrored | Unfollowed -> (k + 1, (k + 1, line))
  in
  let numbered = snd (List.fold_left_map count 0 (shown (Path.lines e))) in
  Drawn.all
    (List.map (fun (k, line) -> draw_line view k line) numbered
    @ List.map (dot view) (shown (Path.hits e)))

open Raylab_geometry
open Raylab_scene
open Raylab_tracer

let pf = Printf.sprintf
let most = 200
let primary = "#1565c0"
let mirrored = "#8e24aa"
let lit = "#e09000"
let blocked = "#d32f2f"

let ink : Path.kind -> string = function
  | Primary -> primary
  | Mirrored | Unfollowed -> mirrored
  | Lit _ -> lit
  | Blocked _ -> blocked

let style (kind : Path.kind) =
  let look =
    match kind with
    | Primary | Mirrored -> {|stroke-width="2.2"|}
    | Unfollowed -> {|stroke-width="2.2" stroke-dasharray="2 3"|}
    | Lit _ | Blocked _ -> {|stroke-width="1.6" stroke-dasharray="6 4"|}
  in
  pf {|stroke="%s" %s|} (ink kind) look

let cross (x, y) =
  let style = pf {|stroke="%s" stroke-width="2.4"|} blocked in
  let arm dx dy = Svg.line ~style (x -. dx, y -. dy) (x +. dx, y +. dy) in
  [ arm 5. 5.; arm 5. (-5.) ]

(* [head ink tip (ux, uy)] is an arrow head of which [tip] is the front. *)
let head ink (x, y) (ux, uy) =
  let at along aside =
    (x +. (along *. ux) -. (aside *. uy), y +. (along *. uy) +. (aside *. ux))
  in
  let style = pf {|fill="%s"|} ink in
  Svg.polygon ~style [ at 0. 0.; at (-11.) 4.5; at (-11.) (-4.5) ]

let way (x, y) (x', y') =
  let dx = x' -. x and dy = y' -. y in
  let length = Float.hypot dx dy in
  (length, (dx /. length, dy /. length))

(* An arrow head in the middle of a line. *)
let arrow kind ((x, y) as a) ((x', y') as b) =
  let length, ((ux, uy) as u) = way a b in
  let tip =
    (((x +. x') /. 2.) +. (6. *. ux), ((y +. y') /. 2.) +. (6. *. uy))
  in
  if length < 30. then [] else [ head (ink kind) tip u ]

(* The number of a ray, beside its middle. *)
let number kind k ((x, y) as a) ((x', y') as b) =
  let length, (ux, uy) = way a b in
  let place =
    (((x +. x') /. 2.) -. (13. *. uy), ((y +. y') /. 2.) +. (13. *. ux) +. 4.)
  in
  if length < 30. then []
  else [ Svg.text ~anchor:"middle" ~color:(ink kind) place (string_of_int k) ]

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
  let color = ink line.kind in
  let _, y = View.inside view (x, y +. 14.) in
  let place = ((if is_left then x +. 12. else x -. 12.), y) in
  let text = Svg.text ~anchor ~size:11. ~color place (destination line) in
  match line.kind with
  | Lit _ when line.length = infinity ->
      (* this is where the light comes in *)
      let _, ((ux, uy) as inwards) = way b a in
      let x, y = b in
      [ head color (x +. (22. *. ux), y +. (22. *. uy)) inwards; text ]
  | _ -> [ text ]

(* A ray that is not followed is only a stub. *)
let stub = 45.

let draw_line (view : View.t) k (line : Path.line) =
  let origin = Ray.origin line.ray
  and direction = (Ray.direction line.ray :> Vec3.t) in
  let length =
    if line.kind = Unfollowed then stub /. view.scale else line.length
  in
  match View.segment view origin direction length with
  | None -> []
  | Some (a, b) ->
      let ends_inside =
        Float.is_finite length
        && View.contains view (View.point view (Ray.at line.ray length))
      in
      let decoration =
        match line.kind with
        | Primary | Mirrored -> arrow line.kind a b @ number line.kind k a b
        | Blocked _ -> if ends_inside then cross b else []
        | Lit _ -> []
        | Unfollowed -> leaving view line a b
      in
      (Svg.line ~style:(style line.kind) a b :: decoration)
      @ if ends_inside then [] else leaving view line a b

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
  if View.contains view place then [ Svg.circle ~style place 4. ] else []

let draw view e =
  let shown items = List.filteri (fun i _ -> i < most) items in
  let count k (line : Path.line) =
    match line.kind with
    | Lit _ | Blocked _ -> (k, (k, line))
    | Primary | Mirrored | Unfollowed -> (k + 1, (k + 1, line))
  in
  let numbered = snd (List.fold_left_map count 0 (shown (Path.lines e))) in
  List.concat_map (fun (k, line) -> draw_line view k line) numbered
  @ List.concat_map (dot view) (shown (Path.hits e))

(* {1 Legend} *)

let entries : (Path.kind * string) list =
  [
    (Primary, "from the eye");
    (Mirrored, "mirrored");
    (Lit 0, "shadow ray to a light");
    (Blocked 0, "shadow ray, blocked");
  ]

let entry_width = 190.
let legend_width = entry_width *. float_of_int (List.length entries)

let legend (x, y) =
  let entry i (kind, words) =
    let x = x +. (entry_width *. float_of_int i) in
    let b = (x +. 34., y) in
    Svg.line ~style:(style kind) (x, y) b
    :: (match kind with Blocked _ -> cross b | _ -> [])
    @ [ Svg.text ~size:11. (x +. 48., y +. 4.) words ]
  in
  List.concat (List.mapi entry entries)

open Raylab_geometry

type side = Inside | Outside | Between

(* Ten times as far as rays start off a surface of usual size. *)
let margin camera (point : Vec3.t) =
  (1e-4 *. Camera.scale camera) +. (1e-12 *. Vec3.length point)

let side camera (o : Object.t) point =
  let depth = Shape.depth o.shape point and margin = margin camera point in
  (* neither for NaN *)
  if depth > margin then Inside
  else if depth < -.margin then Outside
  else Between

(* Of an area light a part may be inside. *)
let light_side camera o (light : Light.t) =
  match light.source with
  | Spherical position | Spot { position; _ } -> side camera o position
  | Directional _ -> Outside
  | Area _ -> Between

type kept = {
  number : int;
  light : Light.t;
  by : int;  (** the number of the object *)
  o : Object.t;
  eye : side;
}

let sentence { number; light; by; o; eye } =
  let name = Warning.name by o in
  let text =
    if eye = Inside then
      Printf.sprintf
        "light %d is outside of %s, in which the eye is, and which keeps its \
         light out"
        number name
    else
      Printf.sprintf "light %d is inside %s, which keeps its light in" number
        name
  in
  { Warning.text; about = [ light.origin; o.origin ] }

(* Pairs of a light and an object that are looked at: some hundredths of a
   second. *)
let most_pairs = 10_000_000

let warnings camera lights objects =
  let eye = Camera.eye camera and objects = Array.of_list objects in
  let sides = Array.map (fun o -> side camera o eye) objects in
  let count = Array.length objects in
  let looked_at = Int.max 1 (most_pairs / Int.max 1 count) in
  let rec keeper light k =
    if k = count then None
    else
      let o = objects.(k) in
      match (sides.(k), light_side camera o light) with
      | (Inside, Outside | Outside, Inside)
        when not (o.is_shadowless || Glasses.lets_through o) ->
          Some k
      | _ -> keeper light (k + 1)
  in
  let kept_in number light =
    let tell k =
      { number; light; by = k + 1; o = objects.(k); eye = sides.(k) }
    in
    Option.map tell (keeper light 0)
  in
  let kept_in k light =
    if k < looked_at then kept_in (k + 1) light else None
  in
  List.mapi kept_in lights |> List.filter_map Fun.id
  |> Warning.few "light" sentence

open Raylab_geometry

type t =
  | Diffusive of Color.t
  | Reflective
  | Luminous of Color.t
  | Mixed of { parts : (float * t) list; nesting : int }

let diffusive c =
  Color.require "a diffusive colour" c;
  Diffusive c

let reflective = Reflective

let luminous c =
  Color.require "a luminous colour" c;
  Luminous c

(* The scene language gives what follows a mix to that mix, so it has no way to
   write a mix before other parts. *)
let[@tail_mod_cons] rec inline_mixes = function
  | (weight, Mixed { parts; _ }) :: (_ :: _ as rest) ->
      let scaled (w, surface) = (Saturate.limit (weight *. w), surface) in
      inline_mixes (List.map scaled parts @ rest)
  | part :: rest -> part :: inline_mixes rest
  | [] -> []

let max_nesting = 1000

(* Only the last part of a mix can be a mix. *)
let rec nesting_of_last = function
  | [ (_, Mixed { nesting; _ }) ] -> nesting
  | [] | [ _ ] -> 0
  | _ :: rest -> nesting_of_last rest

let mixed parts =
  if parts = [] then invalid_arg "a mix of no surfaces";
  List.iter
    (fun (weight, _) -> Number.require Non_negative "a weight" weight)
    parts;
  let parts = inline_mixes parts in
  let nesting = 1 + nesting_of_last parts in
  if nesting > max_nesting then
    invalid_arg "mixes are nested deeper than 1,000";
  Mixed { parts; nesting }

(* {1 Meaning} *)

let rec varies = function
  | Diffusive _ | Reflective | Luminous _ -> false
  | Mixed { parts; _ } -> List.exists (fun (_, part) -> varies part) parts

let levels = function
  | Diffusive _ | Reflective | Luminous _ -> 1
  | Mixed { nesting; _ } -> 1 + nesting

let rec write surface spot numbers at =
  Raw_lobes.clear numbers at;
  match surface with
  | Diffusive c -> Raw_lobes.(set numbers (at + albedo) c)
  | Reflective -> Raw_lobes.(set numbers (at + mirror) Color.white)
  | Luminous c -> Raw_lobes.(set numbers (at + emission) c)
  | Mixed { parts; _ } -> write_parts parts spot numbers at

and write_parts parts spot numbers at =
  match parts with
  | [] -> ()
  | (weight, surface) :: rest ->
      write surface spot numbers (at + Raw_lobes.size);
      Raw_lobes.add_next numbers at weight;
      write_parts rest spot numbers at

let lobes ?(at = Vec3.zero) surface =
  let spot = Spot.create ()
  and numbers = Raw_lobes.create ~rows:(levels surface) in
  Spot.set_own spot at.x at.y at.z;
  write surface spot numbers 0;
  Raw_lobes.read numbers 0

(* [map f surface] is [surface] with [f] applied to each part that is no mix. *)
let rec map f = function
  | Mixed { parts; _ } ->
      mixed (List.map (fun (weight, surface) -> (weight, map f surface)) parts)
  | simple -> f simple

let map_colors f =
  map (function
    | Diffusive c -> diffusive (f c)
    | Luminous c -> luminous (f c)
    | (Reflective | Mixed _) as same -> same)

let paint = function
  | Diffusive c -> Some c
  | Reflective | Luminous _ | Mixed _ -> None

let simple_at (_ : Vec3.t) = function
  | (Diffusive _ | Reflective | Luminous _ | Mixed _) as same -> same

let at surface point =
  if varies surface then map (simple_at point) surface else surface

(* {1 Forms} *)

let rec equal a b =
  match (a, b) with
  | Diffusive a, Diffusive b | Luminous a, Luminous b -> Color.equal a b
  | Reflective, Reflective -> true
  | Mixed a, Mixed b -> List.equal equal_part a.parts b.parts
  | (Diffusive _ | Reflective | Luminous _ | Mixed _), _ -> false

and equal_part (weight, a) (weight', b) = weight = weight' && equal a b

let name = function
  | Diffusive _ -> "diffusive"
  | Reflective -> "reflective"
  | Luminous _ -> "luminous"
  | Mixed _ -> "mixed"

let of_color { Color.r; g; b } = Parameter.Triple (r, g, b)

let parameters = function
  | Diffusive c | Luminous c -> [ ("color", of_color c) ]
  | Reflective | Mixed _ -> []

let rec add_colors found = function
  | Mixed { parts; _ } ->
      List.fold_left (fun found (_, part) -> add_colors found part) found parts
  | simple ->
      let add found : _ * Parameter.t -> _ = function
        | _, Triple (r, g, b) -> Color.make r g b :: found
        | _, Number _ -> found
      in
      List.fold_left add found (parameters simple)

let colors surface = List.rev (add_colors [] surface)

(* Without "%a", which takes so much of the stack that the deepest mixes do not
   fit on that of JavaScript. *)
let rec pp_with pp_number ppf surface =
  let pp_weighted (weight, surface) =
    Format.pp_print_char ppf ' ';
    pp_number ppf weight;
    Format.pp_print_char ppf ' ';
    pp_with pp_number ppf surface
  and pp_parameter (_, parameter) =
    Format.fprintf ppf " %a" (Parameter.pp_with pp_number) parameter
  in
  Format.pp_print_string ppf (name surface);
  match surface with
  | Mixed { parts; _ } -> List.iter pp_weighted parts
  | simple -> List.iter pp_parameter (parameters simple)

let pp = pp_with Number.pp

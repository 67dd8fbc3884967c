open Raylab_geometry

type t =
  | Diffusive of Color.t
  | Reflective
  | Luminous of Color.t
  | Mixed of (float * t) list

let diffusive c =
  Color.require "a diffusive colour" c;
  Diffusive c

let reflective = Reflective

let luminous c =
  Color.require "a luminous colour" c;
  Luminous c

(* The scene language gives what follows a mix to that mix, so it has no way to
   write a mix before other parts. *)
let rec inline_mixes = function
  | (weight, Mixed inner) :: (_ :: _ as rest) ->
      let scaled (w, surface) = (Saturate.limit (weight *. w), surface) in
      inline_mixes (List.map scaled inner @ rest)
  | part :: rest -> part :: inline_mixes rest
  | [] -> []

let mixed parts =
  if parts = [] then invalid_arg "a mix of no surfaces";
  List.iter
    (fun (weight, _) -> Number.require Non_negative "a weight" weight)
    parts;
  Mixed (inline_mixes parts)

type meaning = { emission : Color.t; albedo : Color.t; mirror : float }

let nothing = { emission = Color.black; albedo = Color.black; mirror = 0. }

let rec meaning = function
  | Diffusive c -> { nothing with albedo = c }
  | Reflective -> { nothing with mirror = 1. }
  | Luminous c -> { nothing with emission = c }
  | Mixed parts ->
      let add sum (weight, surface) =
        let part = meaning surface in
        let combine a b = Saturate.color (Color.add a (Color.scale weight b)) in
        {
          emission = combine sum.emission part.emission;
          albedo = combine sum.albedo part.albedo;
          mirror = Saturate.limit (sum.mirror +. (weight *. part.mirror));
        }
      in
      List.fold_left add nothing parts

let rec map_colors f = function
  | Diffusive c -> diffusive (f c)
  | Reflective -> Reflective
  | Luminous c -> luminous (f c)
  | Mixed parts ->
      mixed (List.map (fun (weight, s) -> (weight, map_colors f s)) parts)

let rec equal a b =
  match (a, b) with
  | Diffusive a, Diffusive b | Luminous a, Luminous b -> Color.equal a b
  | Reflective, Reflective -> true
  | Mixed a, Mixed b -> List.equal equal_part a b
  | (Diffusive _ | Reflective | Luminous _ | Mixed _), _ -> false

and equal_part (weight, surface) (weight', surface') =
  weight = weight' && equal surface surface'

let pp_channels ppf (c : Color.t) =
  Format.fprintf ppf "%a %a %a" Number.pp c.r Number.pp c.g Number.pp c.b

let rec pp ppf = function
  | Diffusive c -> Format.fprintf ppf "diffusive %a" pp_channels c
  | Reflective -> Format.pp_print_string ppf "reflective"
  | Luminous c -> Format.fprintf ppf "luminous %a" pp_channels c
  | Mixed parts ->
      let pp_part ppf (weight, surface) =
        Format.fprintf ppf "%a %a" Number.pp weight pp surface
      in
      Format.fprintf ppf "mixed %a"
        (Format.pp_print_list
           ~pp_sep:(fun ppf () -> Format.pp_print_char ppf ' ')
           pp_part)
        parts

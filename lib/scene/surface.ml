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
let[@tail_mod_cons] rec inline_mixes = function
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

(* {1 Nested mixes}

   Only the last part of a mix can be a mix, so mixes nest as a chain. What goes
   along one is a loop: a file may nest a million of them, and a stack as deep
   is gone through anew by every minor collection. *)

(* [unroll [] surface] is the mixes of the chain, the innermost first, each as
   its parts but the last and the weight of that; and the end of the chain. *)
let rec unroll outer = function
  | Mixed parts -> unroll_parts outer [] parts
  | surface -> (outer, surface)

and unroll_parts outer before = function
  | [ (weight, last) ] -> unroll ((List.rev before, weight) :: outer) last
  | part :: rest -> unroll_parts outer (part :: before) rest
  | [] -> invalid_arg "a mix of no surfaces"

let add sum weight part =
  let combine a b = Saturate.color (Color.add a (Color.scale weight b)) in
  {
    emission = combine sum.emission part.emission;
    albedo = combine sum.albedo part.albedo;
    mirror = Saturate.limit (sum.mirror +. (weight *. part.mirror));
  }

let rec meaning = function
  | Diffusive c -> { nothing with albedo = c }
  | Reflective -> { nothing with mirror = 1. }
  | Luminous c -> { nothing with emission = c }
  | Mixed _ as mix ->
      let mixes, last = unroll [] mix in
      let add_part sum (weight, surface) = add sum weight (meaning surface) in
      let around inner (before, weight) =
        add (List.fold_left add_part nothing before) weight inner
      in
      List.fold_left around (meaning last) mixes

let rec map_colors f = function
  | Diffusive c -> diffusive (f c)
  | Reflective -> Reflective
  | Luminous c -> luminous (f c)
  | Mixed _ as mix ->
      let mixes, last = unroll [] mix in
      let map_part (weight, surface) = (weight, map_colors f surface) in
      let around inner (before, weight) =
        mixed (List.map map_part before @ [ (weight, inner) ])
      in
      List.fold_left around (map_colors f last) mixes

let rec equal a b =
  match (a, b) with
  | Diffusive a, Diffusive b | Luminous a, Luminous b -> Color.equal a b
  | Reflective, Reflective -> true
  | Mixed a, Mixed b -> equal_parts a b
  | (Diffusive _ | Reflective | Luminous _ | Mixed _), _ -> false

and equal_parts a b =
  match (a, b) with
  | [ (weight, last) ], [ (weight', last') ] ->
      weight = weight' && equal last last'
  | (weight, surface) :: rest, (weight', surface') :: rest' ->
      weight = weight' && equal surface surface' && equal_parts rest rest'
  | _ -> false

let pp_channels ppf (c : Color.t) =
  Format.fprintf ppf "%a %a %a" Number.pp c.r Number.pp c.g Number.pp c.b

let rec pp ppf = function
  | Diffusive c -> Format.fprintf ppf "diffusive %a" pp_channels c
  | Reflective -> Format.pp_print_string ppf "reflective"
  | Luminous c -> Format.fprintf ppf "luminous %a" pp_channels c
  | Mixed parts ->
      Format.pp_print_string ppf "mixed";
      pp_parts ppf parts

and pp_parts ppf = function
  | [] -> ()
  | (weight, surface) :: rest ->
      Format.fprintf ppf " %a " Number.pp weight;
      if rest = [] then pp ppf surface
      else (
        pp ppf surface;
        pp_parts ppf rest)

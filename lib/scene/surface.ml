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

(* [map f surface] is [surface] with [f] applied to each part that is no mix. *)
let rec map f = function
  | Mixed _ as mix ->
      let mixes, last = unroll [] mix in
      let map_part (weight, surface) = (weight, map f surface) in
      let around inner (before, weight) =
        mixed (List.map map_part before @ [ (weight, inner) ])
      in
      List.fold_left around (map f last) mixes
  | simple -> f simple

let map_colors f =
  map (function
    | Diffusive c -> diffusive (f c)
    | Luminous c -> luminous (f c)
    | (Reflective | Mixed _) as same -> same)

let paint = function
  | Diffusive c -> Some c
  | Reflective | Luminous _ | Mixed _ -> None

(* {1 Surfaces that depend on the point} *)

let rec varies = function
  | Diffusive _ | Reflective | Luminous _ -> false
  | Mixed parts -> some_varies parts

and some_varies = function
  | [] -> false
  | [ (_, last) ] -> varies last
  | (_, surface) :: rest -> varies surface || some_varies rest

let simple_at (_ : Vec3.t) = function
  | (Diffusive _ | Reflective | Luminous _ | Mixed _) as same -> same

let at surface point =
  if varies surface then map (simple_at point) surface else surface

(* {1 Forms} *)

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

let name = function
  | Diffusive _ -> "diffusive"
  | Reflective -> "reflective"
  | Luminous _ -> "luminous"
  | Mixed _ -> "mixed"

type part = Number of float | Color of Color.t

let parts = function
  | Diffusive c | Luminous c -> [ ("color", Color c) ]
  | Reflective | Mixed _ -> []

let pp_part pp_number ppf = function
  | _, Number x -> Format.fprintf ppf " %a" pp_number x
  | _, Color { Color.r; g; b } ->
      Format.fprintf ppf " %a %a %a" pp_number r pp_number g pp_number b

let rec pp_with pp_number ppf surface =
  Format.pp_print_string ppf (name surface);
  match surface with
  | Mixed parts -> pp_mix pp_number ppf parts
  | simple -> List.iter (pp_part pp_number ppf) (parts simple)

(* The last part, which may be a mix of a million mixes, by a tail call. *)
and pp_mix pp_number ppf = function
  | [] -> ()
  | (weight, surface) :: rest ->
      Format.fprintf ppf " %a " pp_number weight;
      if rest = [] then pp_with pp_number ppf surface
      else (
        pp_with pp_number ppf surface;
        pp_mix pp_number ppf rest)

let pp = pp_with Number.pp

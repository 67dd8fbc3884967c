open Raylab_geometry

type t =
  | Diffusive of Color.t
  | Reflective
  | Luminous of Color.t
  | Glossy of { sharpness : float; color : Color.t }
  | Refractive of { index : float; color : Color.t }
  | Glass of { index : float; color : Color.t }
  | Mixed of { parts : (Color.t * t) list; nesting : int }

let diffusive c =
  Color.require "a diffusive colour" c;
  Diffusive c

let reflective = Reflective

let luminous c =
  Color.require "a luminous colour" c;
  Luminous c

let glossy ~sharpness color =
  Number.require Non_negative "a sharpness" sharpness;
  Color.require "a glossy colour" color;
  Glossy { sharpness; color }

let refractive ~index color =
  Number.require Positive "an index" index;
  Color.require "a refractive colour" color;
  Refractive { index; color }

let glass ~index color =
  Number.require Positive "an index" index;
  Color.require "a glass's colour" color;
  Glass { index; color }

(* The scene language gives what follows a mix to that mix, so it has no way to
   write a mix before other parts. *)
let[@tail_mod_cons] rec inline_mixes = function
  | (weight, Mixed { parts; _ }) :: (_ :: _ as rest) ->
      let scaled (w, surface) =
        (Saturate.color (Color.multiply weight w), surface)
      in
      inline_mixes (List.map scaled parts @ rest)
  | part :: rest -> part :: inline_mixes rest
  | [] -> []

let max_nesting = 1000

(* Only the last part of a mix can be a mix. *)
let rec nesting_of_last = function
  | [ (_, Mixed { nesting; _ }) ] -> nesting
  | [] | [ _ ] -> 0
  | _ :: rest -> nesting_of_last rest

let tinted parts =
  if parts = [] then invalid_arg "a mix of no surfaces";
  List.iter (fun (weight, _) -> Color.require "a weight" weight) parts;
  let parts = inline_mixes parts in
  let nesting = 1 + nesting_of_last parts in
  if nesting > max_nesting then
    invalid_arg "mixes are nested deeper than 1,000";
  Mixed { parts; nesting }

let mixed parts =
  let weighted (weight, surface) =
    Number.require Non_negative "a weight" weight;
    (Color.make weight weight weight, surface)
  in
  tinted (List.map weighted parts)

(* {1 Meaning} *)

let rec varies = function
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      false
  | Mixed { parts; _ } -> List.exists (fun (_, part) -> varies part) parts

let rec is_plain = function
  | Diffusive _ | Reflective | Luminous _ -> true
  | Glossy _ | Refractive _ | Glass _ -> false
  | Mixed { parts; _ } -> List.for_all (fun (_, part) -> is_plain part) parts

let rec write_row surface spot raw row =
  Raw_lobes.open_row raw row;
  match surface with
  | Diffusive c -> Raw_lobes.(set raw row albedo c)
  | Reflective -> Raw_lobes.(set raw row mirror Color.white)
  | Luminous c -> Raw_lobes.(set raw row emission c)
  | Glossy { sharpness; color } -> Raw_lobes.add_highlight raw ~sharpness color
  | Refractive { index; color } -> Raw_lobes.add_refractive raw ~index color
  | Glass { index; color } -> Raw_lobes.add_glass raw ~index color
  | Mixed { parts; _ } -> write_parts parts spot raw row

and write_parts parts spot raw row =
  match parts with
  | [] -> ()
  | (weight, surface) :: rest ->
      write_row surface spot raw (row + 1);
      Raw_lobes.mix raw row weight;
      write_parts rest spot raw row

let write surface spot raw =
  Raw_lobes.clear raw;
  write_row surface spot raw 0

let lobes ?(at = Vec3.zero) surface =
  let spot = Spot.create () and raw = Raw_lobes.create () in
  Spot.set_own spot at.x at.y at.z;
  write surface spot raw;
  Raw_lobes.read raw

(* [map ~weight f surface] is [surface] with [f] applied to each part that is no
   mix, and [weight] to each weight. *)
let rec map ?(weight = Fun.id) f = function
  | Mixed { parts; _ } ->
      tinted (List.map (fun (w, part) -> (weight w, map ~weight f part)) parts)
  | simple -> f simple

let map_colors f =
  let weight ({ Color.r; g; b } as w) = if r = g && g = b then w else f w in
  map ~weight (function
    | Diffusive c -> diffusive (f c)
    | Luminous c -> luminous (f c)
    | Glossy { sharpness; color } -> glossy ~sharpness (f color)
    | Refractive { index; color } -> refractive ~index (f color)
    | Glass { index; color } -> glass ~index (f color)
    | (Reflective | Mixed _) as same -> same)

let paint = function
  | Diffusive c -> Some c
  | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _ | Mixed _ ->
      None

let simple_at (_ : Vec3.t) = function
  | ( Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    | Mixed _ ) as same ->
      same

let at surface point =
  if varies surface then map (simple_at point) surface else surface

(* {1 Forms} *)

let rec equal a b =
  match (a, b) with
  | Diffusive a, Diffusive b | Luminous a, Luminous b -> Color.equal a b
  | Reflective, Reflective -> true
  | Glossy a, Glossy b ->
      a.sharpness = b.sharpness && Color.equal a.color b.color
  | Refractive a, Refractive b ->
      a.index = b.index && Color.equal a.color b.color
  | Glass a, Glass b -> a.index = b.index && Color.equal a.color b.color
  | Mixed a, Mixed b -> List.equal equal_part a.parts b.parts
  | ( ( Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _
      | Glass _ | Mixed _ ),
      _ ) ->
      false

and equal_part (weight, a) (weight', b) =
  Color.equal weight weight' && equal a b

let name = function
  | Diffusive _ -> "diffusive"
  | Reflective -> "reflective"
  | Luminous _ -> "luminous"
  | Glossy _ -> "glossy"
  | Refractive _ -> "refractive"
  | Glass _ -> "glass"
  | Mixed _ -> "mixed"

let of_color { Color.r; g; b } = Parameter.Triple (r, g, b)

let parameters = function
  | Diffusive c | Luminous c -> [ ("color", of_color c) ]
  | Glossy { sharpness; color } ->
      [ ("sharpness", Number sharpness); ("color", of_color color) ]
  | Refractive { index; color } | Glass { index; color } ->
      [ ("index", Number index); ("color", of_color color) ]
  | Reflective | Mixed _ -> []

let weight { Color.r; g; b } =
  if r = g && g = b then Parameter.Number r else Triple (r, g, b)

let rec add_colors found = function
  | Mixed { parts; _ } ->
      let add found (w, part) =
        let is_number = Parameter.equal (weight w) (Number w.r) in
        add_colors (if is_number then found else w :: found) part
      in
      List.fold_left add found parts
  | simple ->
      let add found : _ * Parameter.t -> _ = function
        | _, Triple (r, g, b) -> Color.make r g b :: found
        | _, (Number _ | Text _ | Word _) -> found
      in
      List.fold_left add found (parameters simple)

let colors surface = List.rev (add_colors [] surface)

let pp_weight pp_number ppf w =
  match weight w with
  | Triple (r, g, b) ->
      Format.fprintf ppf "[%a, %a, %a]" pp_number r pp_number g pp_number b
  | number -> Parameter.pp_with pp_number ppf number

(* Without "%a", which takes so much of the stack that the deepest mixes do not
   fit on that of JavaScript. *)
let rec pp_with pp_number ppf surface =
  let pp_weighted (w, surface) =
    Format.pp_print_char ppf ' ';
    pp_weight pp_number ppf w;
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

open Raylab_geometry

type t =
  | Diffusive of Color.t
  | Reflective
  | Luminous of Color.t
  | Glossy of { sharpness : float; color : Color.t }
  | Refractive of { index : float; color : Color.t }
  | Glass of { index : float; color : Color.t }
  | Mixed of { parts : (Color.t * t) list; nesting : int }
  | Checker of { size : float; even : t; odd : t; nesting : int; count : int }

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

let nesting = function
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      0
  | Mixed { nesting; _ } | Checker { nesting; _ } -> nesting

let tinted parts =
  if parts = [] then invalid_arg "a mix of no surfaces";
  List.iter (fun (weight, _) -> Color.require "a weight" weight) parts;
  let parts = inline_mixes parts in
  let deeper deepest (_, part) = Int.max deepest (nesting part) in
  let nesting = 1 + List.fold_left deeper 0 parts in
  if nesting > max_nesting then
    invalid_arg "mixes are nested deeper than 1,000";
  Mixed { parts; nesting }

let mixed parts =
  let weighted (weight, surface) =
    Number.require Non_negative "a weight" weight;
    (Color.make weight weight weight, surface)
  in
  tinted (List.map weighted parts)

(* What has a name may be a part many times. *)
let most_counted = 1_000_000_000

let rec count = function
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      1
  | Checker { count; _ } -> count
  | Mixed { parts; _ } ->
      let add sum (_, part) = Int.min most_counted (sum + count part) in
      List.fold_left add 1 parts

let checker size even odd =
  Number.require Positive "the size of a checker" size;
  let nesting = 1 + Int.max (nesting even) (nesting odd) in
  if nesting > max_nesting then
    invalid_arg "checkers are nested deeper than 1,000";
  let count = Int.min most_counted (1 + count even + count odd) in
  Checker { size; even; odd; nesting; count }

(* {1 Meaning} *)

let rec varies = function
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      false
  | Checker _ -> true
  | Mixed { parts; _ } -> List.exists (fun (_, part) -> varies part) parts

let rec is_plain = function
  | Diffusive _ | Reflective | Luminous _ -> true
  | Glossy _ | Refractive _ | Glass _ -> false
  | Mixed { parts; _ } -> List.for_all (fun (_, part) -> is_plain part) parts
  | Checker { even; odd; _ } -> is_plain even && is_plain odd

(* Faces often lie between two cubes; what little their points are off must not
   show. *)
let margin = 0x1p-30

(* 1 if the greatest whole number that is at most [x] is odd, else 0. *)
let[@inline] parity x =
  let whole = floor (x +. margin) in
  whole -. (2. *. floor (0.5 *. whole))

(* Whether a point lies in one of the odd cubes. *)
let[@inline] is_odd size x y z =
  let x = parity (x /. size) = 1.
  and y = parity (y /. size) = 1.
  and z = parity (z /. size) = 1. in
  x <> (y <> z)

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
  | Checker { size; even; odd; _ } ->
      let { Spot.own_x; own_y; own_z; _ } = spot in
      let here = if is_odd size own_x own_y own_z then odd else even in
      write_row here spot raw row

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

let map_weight f ({ Color.r; g; b } as w) = if r = g && g = b then w else f w

let rec map_colors f = function
  | Diffusive c -> diffusive (f c)
  | Reflective -> Reflective
  | Luminous c -> luminous (f c)
  | Glossy { sharpness; color } -> glossy ~sharpness (f color)
  | Refractive { index; color } -> refractive ~index (f color)
  | Glass { index; color } -> glass ~index (f color)
  | Mixed { parts; _ } ->
      let part (weight, surface) =
        (map_weight f weight, map_colors f surface)
      in
      tinted (List.map part parts)
  | Checker { size; even; odd; _ } ->
      checker size (map_colors f even) (map_colors f odd)

let paint = function
  | Diffusive c -> Some c
  | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _ | Mixed _
  | Checker _ ->
      None

let rec at surface (point : Vec3.t) =
  match surface with
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      surface
  | Checker { size; even; odd; _ } ->
      at (if is_odd size point.x point.y point.z then odd else even) point
  | Mixed { parts; _ } when varies surface ->
      tinted (List.map (fun (weight, part) -> (weight, at part point)) parts)
  | Mixed _ -> surface

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
  | Checker a, Checker b ->
      a.size = b.size && equal a.even b.even && equal a.odd b.odd
  | ( ( Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _
      | Glass _ | Mixed _ | Checker _ ),
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
  | Checker _ -> "checker"

let of_color { Color.r; g; b } = Parameter.Triple (r, g, b)

let parameters = function
  | Diffusive c | Luminous c -> [ ("color", of_color c) ]
  | Glossy { sharpness; color } ->
      [ ("sharpness", Number sharpness); ("color", of_color color) ]
  | Refractive { index; color } | Glass { index; color } ->
      [ ("index", Number index); ("color", of_color color) ]
  | Checker { size; _ } -> [ ("size", Number size) ]
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
  | Checker { even; odd; _ } -> add_colors (add_colors found even) odd
  | simple ->
      let add found : _ * Parameter.t -> _ = function
        | _, Triple (r, g, b) -> Color.make r g b :: found
        | _, Number _ -> found
      in
      List.fold_left add found (parameters simple)

let colors surface = List.rev (add_colors [] surface)

let rec add_simple found = function
  | Mixed { parts; _ } ->
      List.fold_left (fun found (_, part) -> add_simple found part) found parts
  | Checker { even; odd; _ } -> add_simple (add_simple found even) odd
  | simple -> simple :: found

let simple surface = List.rev (add_simple [] surface)

(* Whether a weight after it would belong to a mix in it. *)
let rec ends_in_mix = function
  | Mixed _ -> true
  | Checker { odd; _ } -> ends_in_mix odd
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      false

(* The last one first. *)
let rec add_to_name found = function
  | Checker { even; odd; _ } -> add_to_name (add_to_name found even) odd
  | Mixed { parts; _ } -> add_parts_to_name found parts
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      found

and add_parts_to_name found = function
  | [] -> found
  | [ (_, last) ] -> add_to_name found last
  | (_, part) :: rest ->
      let found = add_to_name found part in
      let found = if ends_in_mix part then part :: found else found in
      add_parts_to_name found rest

let parts_to_name surface = List.rev (add_to_name [] surface)

let pp_weight pp_number ppf w =
  match weight w with
  | Number x -> pp_number ppf x
  | Triple (r, g, b) ->
      Format.fprintf ppf "[%a, %a, %a]" pp_number r pp_number g pp_number b

(* Without "%a", which takes so much of the stack that the deepest mixes do not
   fit on that of JavaScript. *)
let rec pp_with ?(name_of = fun _ -> None) pp_number ppf surface =
  let pp_parameter (_, parameter) =
    Format.fprintf ppf " %a" (Parameter.pp_with pp_number) parameter
  and pp_next surface =
    Format.pp_print_char ppf ' ';
    pp_with ~name_of pp_number ppf surface
  in
  Format.pp_print_string ppf (name surface);
  List.iter pp_parameter (parameters surface);
  match surface with
  | Mixed { parts; _ } -> pp_parts name_of pp_number ppf parts
  | Checker { even; odd; _ } ->
      pp_next even;
      pp_next odd
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      ()

and pp_parts name_of pp_number ppf = function
  | [] -> ()
  | (weight, surface) :: rest ->
      Format.pp_print_char ppf ' ';
      pp_weight pp_number ppf weight;
      Format.pp_print_char ppf ' ';
      if rest <> [] && ends_in_mix surface then
        pp_apart name_of pp_number ppf surface
      else pp_with ~name_of pp_number ppf surface;
      pp_parts name_of pp_number ppf rest

(* Somebody who reads sees by brackets which weights belong to it. *)
and pp_apart name_of pp_number ppf surface =
  match name_of surface with
  | Some name -> Format.pp_print_string ppf name
  | None ->
      Format.pp_print_char ppf '(';
      pp_with ~name_of pp_number ppf surface;
      Format.pp_print_char ppf ')'

let pp = pp_with Number.pp

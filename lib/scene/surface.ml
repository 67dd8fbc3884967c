open Raylab_geometry
open Raylab_expression

type t =
  | Diffusive of Color.t
  | Reflective
  | Luminous of Color.t
  | Glossy of { sharpness : float; color : Color.t }
  | Refractive of { index : float; color : Color.t }
  | Glass of { index : float; color : Color.t }
  | Mixed of { parts : (Color.t * t) list; nesting : int }
  | Checker of { size : float; even : t; odd : t; nesting : int; count : int }
  | Varying of { pattern : t Closed.t; grey : bool; nesting : int }

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
  | Mixed { nesting; _ } | Checker { nesting; _ } | Varying { nesting; _ } ->
      nesting

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
  | Varying { pattern; _ } ->
      let add sum part = Int.min most_counted (sum + count part) in
      List.fold_left add 1 (Closed.things pattern)

let checker size even odd =
  Number.require Positive "the size of a checker" size;
  let nesting = 1 + Int.max (nesting even) (nesting odd) in
  if nesting > max_nesting then
    invalid_arg "checkers are nested deeper than 1,000";
  let count = Int.min most_counted (1 + count even + count odd) in
  Checker { size; even; odd; nesting; count }

let varying pattern =
  let deeper deepest part = Int.max deepest (nesting part) in
  let nesting = 1 + List.fold_left deeper 0 (Closed.things pattern) in
  if nesting > max_nesting then
    invalid_arg "surfaces are nested deeper than 1,000";
  Varying { pattern; grey = false; nesting }

(* {1 Meaning} *)

let rec varies = function
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      false
  | Checker _ | Varying _ -> true
  | Mixed { parts; _ } -> List.exists (fun (_, part) -> varies part) parts

let rec has_patterns = function
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      false
  | Varying _ -> true
  | Checker { even; odd; _ } -> has_patterns even || has_patterns odd
  | Mixed { parts; _ } ->
      List.exists (fun (_, part) -> has_patterns part) parts

let rec is_plain = function
  | Diffusive _ | Reflective | Luminous _ -> true
  | Glossy _ | Refractive _ | Glass _ -> false
  | Mixed { parts; _ } -> List.for_all (fun (_, part) -> is_plain part) parts
  | Checker { even; odd; _ } -> is_plain even && is_plain odd
  | Varying _ -> false

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

(* {1 Patterns} *)

let grey c = Grey.(to_color (of_color c))

let rec add_patterns found = function
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      found
  | Mixed { parts; _ } ->
      List.fold_left
        (fun found (_, part) -> add_patterns found part)
        found parts
  | Checker { even; odd; _ } -> add_patterns (add_patterns found even) odd
  | Varying { pattern; _ } when List.mem_assq pattern found -> found
  | Varying { pattern; grey; _ } ->
      List.fold_left add_patterns ((pattern, grey) :: found)
        (Closed.things pattern)

let name_of_color = "the surface's colour"

let surface_of run (e : Expression.t) = function
  | Value.Thing surface -> surface
  | value -> Operation.wanted run e "a surface" value

let weight_of color run e : t Value.t -> Color.t = function
  | Vector _ as value -> color (Pattern.color "the weight" run e value)
  | value ->
      let x = Pattern.number Non_negative "the weight" run e value in
      Color.make x x x

let rec parts_of color run arguments values =
  match (arguments, values) with
  | (_, w) :: (_, s) :: arguments, weight :: surface :: values ->
      let weight = weight_of color run w weight in
      let surface = surface_of run s surface in
      (weight, surface) :: parts_of color run arguments values
  | _ -> []

let nested (e : Expression.t) make =
  try make () with Invalid_argument message -> Fault.fail e.span message

(* What a word of a pattern makes of its arguments; [color] is what is made of
   each colour. *)
let make ~color run (e : Expression.t) values : t Value.t =
  let number rule name = Pattern.number rule name run
  and color_of e value = color (Pattern.color name_of_color run e value) in
  match (e.desc, values) with
  | Word { word = "diffusive"; arguments = [ (_, c) ] }, [| v |] ->
      Thing (Diffusive (color_of c v))
  | Word { word = "luminous"; arguments = [ (_, c) ] }, [| v |] ->
      Thing (Luminous (color_of c v))
  | Word { word = "reflective"; _ }, _ -> Thing Reflective
  | Word { word = "glossy"; arguments = [ (_, s); (_, c) ] }, [| v; w |] ->
      let sharpness = number Non_negative "the sharpness" s v in
      Thing (Glossy { sharpness; color = color_of c w })
  | Word { word = "refractive"; arguments = [ (_, i); (_, c) ] }, [| v; w |] ->
      let index = number Positive "the index" i v in
      Thing (Refractive { index; color = color_of c w })
  | Word { word = "glass"; arguments = [ (_, i); (_, c) ] }, [| v; w |] ->
      let index = number Positive "the index" i v in
      Thing (Glass { index; color = color_of c w })
  | ( Word { word = "checker"; arguments = [ (_, a); (_, s); (_, s') ] },
      [| size; even; odd |] ) ->
      let size = number Positive "the size of the checker" a size in
      let even = surface_of run s even in
      let odd = surface_of run s' odd in
      Thing (nested e (fun () -> checker size even odd))
  | Word { word = "mixed"; arguments }, values ->
      let parts = parts_of color run arguments (Array.to_list values) in
      Thing (nested e (fun () -> tinted parts))
  | _ -> invalid_arg "Surface: a word that makes no surface"

let read { Closed.body; _ } run = surface_of run body
let patterns surface = List.rev_map fst (add_patterns [] surface)

type ready = (t Closed.t * (bool * t Closed.code)) list

let ready surface : ready =
  let compile (pattern, grey) = (pattern, (grey, Closed.compile pattern)) in
  List.map compile (add_patterns [] surface)

type machines = (t Closed.t * t Closed.machine) list

let no_machines : machines = []

let start (ready : ready) : machines =
  let machine (pattern, (is_grey, code)) =
    let color = if is_grey then grey else Fun.id in
    (pattern, Pattern.start ~make:(make ~color) code)
  in
  List.map machine ready

let evaluate (machines : machines) pattern point =
  Pattern.value (List.assq pattern machines) point (read pattern)

(* {1 Lobes} *)

let rec write_row machines surface (spot : Spot.t) raw row =
  Raw_lobes.open_row raw row;
  match surface with
  | Diffusive c -> Raw_lobes.(set raw row albedo c)
  | Reflective -> Raw_lobes.(set raw row mirror Color.white)
  | Luminous c -> Raw_lobes.(set raw row emission c)
  | Glossy { sharpness; color } -> Raw_lobes.add_highlight raw ~sharpness color
  | Refractive { index; color } -> Raw_lobes.add_refractive raw ~index color
  | Glass { index; color } -> Raw_lobes.add_glass raw ~index color
  | Mixed { parts; _ } -> write_parts machines parts spot raw row
  | Checker { size; even; odd; _ } ->
      let { Spot.own_x; own_y; own_z; _ } = spot in
      let here = if is_odd size own_x own_y own_z then odd else even in
      write_row machines here spot raw row
  | Varying { pattern; _ } ->
      let here = evaluate machines pattern (Spot.own spot) in
      write_row machines here spot raw row

and write_parts machines parts spot raw row =
  match parts with
  | [] -> ()
  | (weight, surface) :: rest ->
      write_row machines surface spot raw (row + 1);
      Raw_lobes.mix raw row weight;
      write_parts machines rest spot raw row

let write machines surface spot raw =
  Raw_lobes.clear raw;
  write_row machines surface spot raw 0

let lobes ?(at = Vec3.zero) surface =
  let spot = Spot.create () and raw = Raw_lobes.create () in
  Spot.set_own spot at.x at.y at.z;
  write (start (ready surface)) surface spot raw;
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
  | Varying v ->
      Varying { v with pattern = Closed.map (map_colors f) v.pattern }

let rec greyscale = function
  | Mixed { parts; _ } ->
      let part (weight, surface) =
        (map_weight grey weight, greyscale surface)
      in
      tinted (List.map part parts)
  | Checker { size; even; odd; _ } ->
      checker size (greyscale even) (greyscale odd)
  | Varying v ->
      let pattern = Closed.map greyscale v.pattern in
      Varying { v with pattern; grey = true }
  | simple -> map_colors grey simple

let paint = function
  | Diffusive c -> Some c
  | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _ | Mixed _
  | Checker _ | Varying _ ->
      None

let rec resolve machines surface (point : Vec3.t) =
  let at = resolve machines in
  match surface with
  | Varying { pattern; _ } -> at (evaluate machines pattern point) point
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      surface
  | Checker { size; even; odd; _ } ->
      at (if is_odd size point.x point.y point.z then odd else even) point
  | Mixed { parts; _ } when varies surface ->
      tinted (List.map (fun (weight, part) -> (weight, at part point)) parts)
  | Mixed _ -> surface

let at surface = resolve (start (ready surface)) surface

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
  | Varying a, Varying b ->
      a.grey = b.grey && Closed.equal equal a.pattern b.pattern
  | ( ( Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _
      | Glass _ | Mixed _ | Checker _ | Varying _ ),
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
  | Varying _ -> "varying"

let of_color { Color.r; g; b } = Parameter.Triple (r, g, b)

let parameters = function
  | Diffusive c | Luminous c -> [ ("color", of_color c) ]
  | Glossy { sharpness; color } ->
      [ ("sharpness", Number sharpness); ("color", of_color color) ]
  | Refractive { index; color } | Glass { index; color } ->
      [ ("index", Number index); ("color", of_color color) ]
  | Checker { size; _ } -> [ ("size", Number size) ]
  | Reflective | Mixed _ | Varying _ -> []

let weight { Color.r; g; b } =
  if r = g && g = b then Parameter.Number r else Triple (r, g, b)

(* Where a surface that varies is looked at, to say something of all of it. *)
let probes =
  let numbers = [ -1.3; 1.7 ] in
  List.concat_map
    (fun x ->
      List.concat_map
        (fun y -> List.map (fun z -> Vec3.make x y (z +. 0.1)) numbers)
        numbers)
    numbers

let probe surface =
  let machines = start (ready surface) in
  let here point =
    try Some (resolve machines surface point) with Pattern.Failed _ -> None
  in
  List.filter_map here probes

let rec add_colors found = function
  | Mixed { parts; _ } ->
      let add found (w, part) =
        let is_number = Parameter.equal (weight w) (Number w.r) in
        add_colors (if is_number then found else w :: found) part
      in
      List.fold_left add found parts
  | Checker { even; odd; _ } -> add_colors (add_colors found even) odd
  | Varying _ as surface -> List.fold_left add_colors found (probe surface)
  | simple ->
      let add found : _ * Parameter.t -> _ = function
        | _, Triple (r, g, b) -> Color.make r g b :: found
        | _, (Number _ | Text _ | Word _) -> found
      in
      List.fold_left add found (parameters simple)

let colors surface = List.rev (add_colors [] surface)

let rec add_simple found = function
  | Mixed { parts; _ } ->
      List.fold_left (fun found (_, part) -> add_simple found part) found parts
  | Checker { even; odd; _ } -> add_simple (add_simple found even) odd
  | Varying _ as surface -> List.fold_left add_simple found (probe surface)
  | simple -> simple :: found

let simple surface = List.rev (add_simple [] surface)

(* {1 Text} *)

let rec expression_ends_in_mix (e : Expression.t) =
  match e.desc with
  | Word { word = "mixed"; _ } -> true
  | Word { word = "checker"; arguments = [ _; _; (_, odd) ] } ->
      expression_ends_in_mix odd
  | Varying { body; _ } -> expression_ends_in_mix body
  | _ -> false

(* Whether a weight after it would belong to a mix in it. *)
let rec ends_in_mix = function
  | Mixed _ -> true
  | Checker { odd; _ } -> ends_in_mix odd
  | Varying { pattern; _ } -> expression_ends_in_mix pattern.body
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      false

let add_once found part = if List.memq part found then found else part :: found

(* The last one first. *)
let rec add_to_name found surface =
  match surface with
  | Checker { even; odd; _ } -> add_to_name (add_to_name found even) odd
  | Mixed { parts; _ } -> add_parts_to_name found parts
  | Varying { pattern = { definitions = []; _ }; _ } -> found
  | Varying { pattern; _ } ->
      let found = List.fold_left add_to_name found (Closed.things pattern) in
      (* in a list only names can stand *)
      surface :: List.fold_left add_once found (Closed.listed pattern)
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      found

and add_parts_to_name found = function
  | [] -> found
  | [ (_, last) ] -> add_to_name found last
  | (_, part) :: rest ->
      let found = add_to_name found part in
      let found = if ends_in_mix part then add_once found part else found in
      add_parts_to_name found rest

let parts_to_name surface = List.rev (add_to_name [] surface)

let pp_weight pp_number ppf w =
  match weight w with
  | Triple (r, g, b) ->
      Format.fprintf ppf "[%a, %a, %a]" pp_number r pp_number g pp_number b
  | number -> Parameter.pp_with pp_number ppf number

let no_name _ = None

(* Without "%a", which takes so much of the stack that the deepest mixes do not
   fit on that of JavaScript. *)
let rec pp_form_with ?(name_of = no_name) pp_number ppf surface =
  let pp_parameter (_, parameter) =
    Format.fprintf ppf " %a" (Parameter.pp_with pp_number) parameter
  in
  Format.pp_print_string ppf (name surface);
  List.iter pp_parameter (parameters surface);
  match surface with
  | Mixed { parts; _ } -> pp_parts name_of pp_number ppf parts
  | Checker { even; odd; _ } ->
      Format.pp_print_char ppf ' ';
      pp_with ~name_of pp_number ppf even;
      Format.pp_print_char ppf ' ';
      pp_with ~name_of pp_number ppf odd
  | Varying { pattern = { name; body; _ }; _ } ->
      Format.fprintf ppf " %s%a" name Expression.pp_bare (Surface, body)
  | Diffusive _ | Reflective | Luminous _ | Glossy _ | Refractive _ | Glass _
    ->
      ()

and pp_with ?(name_of = no_name) pp_number ppf surface =
  match name_of surface with
  | Some name -> Format.pp_print_string ppf name
  | None -> pp_form_with ~name_of pp_number ppf surface

and pp_parts name_of pp_number ppf = function
  | [] -> ()
  | (weight, surface) :: rest ->
      (* somebody who reads sees by brackets which weights belong to it *)
      let is_apart =
        rest <> [] && ends_in_mix surface && name_of surface = None
      in
      Format.pp_print_char ppf ' ';
      pp_weight pp_number ppf weight;
      Format.pp_print_string ppf (if is_apart then " (" else " ");
      pp_with ~name_of pp_number ppf surface;
      if is_apart then Format.pp_print_char ppf ')';
      pp_parts name_of pp_number ppf rest

let pp = pp_with Number.pp

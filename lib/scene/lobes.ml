open Raylab_geometry

type highlight = { sharpness : float; shine : Color.t }

type refraction = {
  index : float;
  plain : Color.t;
  fresnel : Color.t;
  glass : Color.t;
}

type t = {
  emission : Color.t;
  albedo : Color.t;
  mirror : Color.t;
  highlights : highlight list;
  refractions : refraction list;
}

let none =
  {
    emission = Color.black;
    albedo = Color.black;
    mirror = Color.black;
    highlights = [];
    refractions = [];
  }

let is_black = Color.equal Color.black

let is_none { emission; albedo; mirror; highlights; refractions } =
  List.for_all is_black [ emission; albedo; mirror ]
  && List.for_all (fun { shine; _ } -> is_black shine) highlights
  && List.for_all
       (fun { plain; fresnel; glass; _ } ->
         List.for_all is_black [ plain; fresnel; glass ])
       refractions

let equal_highlight a b =
  a.sharpness = b.sharpness && Color.equal a.shine b.shine

let equal_refraction a b =
  a.index = b.index
  && Color.equal a.plain b.plain
  && Color.equal a.fresnel b.fresnel
  && Color.equal a.glass b.glass

let equal a b =
  Color.equal a.emission b.emission
  && Color.equal a.albedo b.albedo
  && Color.equal a.mirror b.mirror
  && List.equal equal_highlight a.highlights b.highlights
  && List.equal equal_refraction a.refractions b.refractions

(* {1 Printing} *)

let pp_factor ppf ({ Color.r; g; b } as color) =
  if r = g && g = b then Number.pp ppf r else Color.pp ppf color

let pp_highlight ppf { sharpness; shine } =
  Format.fprintf ppf ",@ highlight of sharpness %a:@ %a" Number.pp sharpness
    pp_factor shine

(* [share] is what [factor] is multiplied by, unless that is 1. *)
let pp_times share ppf factor =
  if Color.equal factor Color.white then Format.pp_print_string ppf share
  else Format.fprintf ppf "%s * %a" share pp_factor factor

let pp_refraction ppf { index; plain; fresnel; glass } =
  if not (is_black plain) then
    Format.fprintf ppf ",@ refraction of index %a:@ %a" Number.pp index
      pp_factor plain;
  if not (is_black fresnel && is_black glass) then
    Format.fprintf ppf ",@ glass of index %a:@ %a mirrored,@ %a through"
      Number.pp index (pp_times "F") fresnel (pp_times "(1 - F)") glass

let pp_with color ppf { emission; albedo; mirror; highlights; refractions } =
  Format.fprintf ppf "emission %a,@ albedo %a,@ mirror %a" color emission color
    albedo pp_factor mirror;
  List.iter (pp_highlight ppf) highlights;
  List.iter (pp_refraction ppf) refractions

let pp = pp_with Color.pp

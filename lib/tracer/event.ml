open Raylab_geometry
open Raylab_scene

type role = Primary | Mirrored | Refracted

type source =
  | Background
  | Emitted
  | Diffused of { light : Color.t }
  | Mirror of { weight : Color.t }
  | Refraction of {
      index : float;
      weight : Color.t;
      share : float;
      cosine : float;
    }

type term = { source : source; color : Color.t }
type obstacle = { by : int; primitive : int option; t : float; point : Vec3.t }
type crossing = { met : obstacle; part : Color.t }

type t =
  | Opened of { role : role; ray : Ray.t; left : int }
  | Met of Hit.t
  | Faces_away of { light : int; cosine : float }
  | Shadow_ray of { light : int; ray : Ray.t }
  | Blocked of {
      light : int;
      by : int;
      primitive : int option;
      t : float;
      point : Vec3.t;
    }
  | Lit of {
      light : int;
      cosine : float;
      falloff : float;
      contribution : Color.t;
      past : int option;
      through : crossing list;
    }
  | Closed of { left : int; terms : term list; color : Color.t }
  | Done of Color.t

let role = function
  | Primary -> "cast"
  | Mirrored -> "bounce"
  | Refracted -> "refract"

let sends source =
  let is_some weight = not (Color.equal weight Color.black) in
  match source with
  | Background | Emitted | Diffused _ -> None
  | Mirror { weight } -> if is_some weight then Some Mirrored else None
  | Refraction { weight; _ } -> if is_some weight then Some Refracted else None

let source_name = function
  | Background -> "background"
  | Emitted -> "emitted"
  | Diffused _ -> "diffused"
  | Mirror _ -> "mirrored"
  | Refraction _ -> "refracted"

let pp_bend ppf = function
  | Refraction { cosine = 0.; _ } ->
      Format.pp_print_string ppf " (totally reflected)"
  | Refraction { index; share; _ } ->
      Format.fprintf ppf " (index %a, Fresnel's share %a)" Number.pp index
        Number.pp share
  | Background | Emitted | Diffused _ | Mirror _ -> ()

let pp_term ppf term =
  Format.fprintf ppf "%s %a%a" (source_name term.source) Color.pp term.color
    pp_bend term.source

let pp_sum ppf =
  Format.pp_print_list
    ~pp_sep:(fun ppf () -> Format.pp_print_string ppf " + ")
    pp_term ppf

let pp_object ppf (number, primitive) =
  Format.fprintf ppf "object %d" number;
  Option.iter (Format.fprintf ppf ".%d") primitive

let pp_past ppf number =
  Format.fprintf ppf ", past object %d, which is shadowless" number

let pp_crossing ppf { met = { by; primitive; _ }; part } =
  Format.fprintf ppf ", through %a, which lets through %a" pp_object
    (by, primitive) Lobes.pp_factor part

let pp ppf = function
  | Opened { role = r; ray; left } ->
      Format.fprintf ppf "%s: %a, %d left in the chain" (role r) Ray.pp ray
        left
  | Met hit ->
      Format.fprintf ppf "nearest hit: %a, %a" pp_object
        (hit.number, hit.primitive)
        Hit.pp hit
  | Faces_away { light; cosine } ->
      Format.fprintf ppf "light %d: faces away, cosine %a" light Number.pp
        cosine
  | Shadow_ray { light; ray } ->
      Format.fprintf ppf "shadow ray to light %d: %a" light Ray.pp ray
  | Blocked { light; by; primitive; t; point } ->
      Format.fprintf ppf "light %d: blocked by %a, t = %a at %a" light
        pp_object (by, primitive) Number.pp t Vec3.pp point
  | Lit { light; cosine; falloff; contribution; past; through } ->
      Format.fprintf ppf "light %d: lit, cosine %a, fall-off %a%a, gives %a%a"
        light Number.pp cosine Number.pp falloff
        (Format.pp_print_list ~pp_sep:(fun _ () -> ()) pp_crossing)
        through Color.pp contribution
        (Format.pp_print_option pp_past)
        past
  | Closed { terms = [ { source = Background; _ } ]; left; color } ->
      Format.fprintf ppf "%s: the background, %a"
        (if left = 0 then "chain ended" else "nothing hit")
        Color.pp color
  | Closed { terms; color; _ } ->
      Format.fprintf ppf "mix: %a = %a" pp_sum terms Color.pp color
  | Done color -> Format.fprintf ppf "done: %a" Color.pp color

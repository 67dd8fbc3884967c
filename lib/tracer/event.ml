open Raylab_geometry
open Raylab_scene

type role = Primary | Mirrored | Refracted

type source =
  | Background
  | Emitted
  | Diffused of { ambient : Color.t; light : Color.t }
  | Shine of { sharpness : float; shine : Color.t }
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
type cone = { angle : float; part : float }

type t =
  | Opened of { role : role; ray : Ray.t; left : int }
  | Met of Hit.t
  | Faces_away of { light : int; cell : int option; cosine : float }
  | Outside of { light : int; angle : float }
  | Shadow_ray of { light : int; cell : int option; ray : Ray.t }
  | Blocked of {
      light : int;
      cell : int option;
      by : int;
      primitive : int option;
      t : float;
      point : Vec3.t;
    }
  | Lit of {
      light : int;
      cell : int option;
      cosine : float;
      falloff : float;
      cone : cone option;
      contribution : Color.t;
      shines : Color.t list;
      past : int option;
      through : crossing list;
    }
  | Mean of {
      light : int;
      points : int;
      contribution : Color.t;
      shines : Color.t list;
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
  | Background | Emitted | Diffused _ | Shine _ -> None
  | Mirror { weight } -> if is_some weight then Some Mirrored else None
  | Refraction { weight; _ } -> if is_some weight then Some Refracted else None

let source_name = function
  | Background -> "background"
  | Emitted -> "emitted"
  | Diffused _ -> "diffused"
  | Shine _ -> "shine"
  | Mirror _ -> "mirrored"
  | Refraction _ -> "refracted"

let pp_bend ppf = function
  | Refraction { cosine = 0.; _ } ->
      Format.pp_print_string ppf " [totally reflected]"
  | Refraction { index; share; _ } ->
      Format.fprintf ppf " [index %a, Fresnel's share %a]" Number.pp index
        Number.pp share
  | Background | Emitted | Diffused _ | Shine _ | Mirror _ -> ()

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

let pp_light ppf (light, cell) =
  Format.fprintf ppf "light %d" light;
  Option.iter (Format.fprintf ppf ", point %d") cell

let pp_cone ppf { angle; part } =
  Format.fprintf ppf ", %a degrees from the axis: part %a" Number.pp angle
    Number.pp part

let pp_shines ppf =
  List.iter (Format.fprintf ppf ", and to a highlight %a" Color.pp)

let pp ppf = function
  | Opened { role = r; ray; left } ->
      Format.fprintf ppf "%s: %a, %d left in the chain" (role r) Ray.pp ray
        left
  | Met hit ->
      Format.fprintf ppf "nearest hit: %a, %a" pp_object
        (hit.number, hit.primitive)
        Hit.pp hit
  | Faces_away { light; cell; cosine } ->
      Format.fprintf ppf "%a: faces away, cosine %a" pp_light (light, cell)
        Number.pp cosine
  | Outside { light; angle } ->
      Format.fprintf ppf
        "light %d: outside of its cone, %a degrees from the axis" light
        Number.pp angle
  | Shadow_ray { light; cell; ray } ->
      Format.fprintf ppf "shadow ray to %a: %a" pp_light (light, cell) Ray.pp
        ray
  | Blocked { light; cell; by; primitive; t; point } ->
      Format.fprintf ppf "%a: blocked by %a, t = %a at %a" pp_light
        (light, cell) pp_object (by, primitive) Number.pp t Vec3.pp point
  | Lit
      {
        light;
        cell;
        cosine;
        falloff;
        cone;
        contribution;
        shines;
        past;
        through;
      } ->
      Format.fprintf ppf "%a: lit, cosine %a, fall-off %a%a%a, gives %a%a%a"
        pp_light (light, cell) Number.pp cosine Number.pp falloff
        (Format.pp_print_option pp_cone)
        cone
        (Format.pp_print_list ~pp_sep:(fun _ () -> ()) pp_crossing)
        through Color.pp contribution pp_shines shines
        (Format.pp_print_option pp_past)
        past
  | Mean { light; points; contribution; shines } ->
      Format.fprintf ppf "light %d: the mean of its %d points gives %a%a" light
        points Color.pp contribution pp_shines shines
  | Closed { terms = [ { source = Background; _ } ]; left; color } ->
      Format.fprintf ppf "%s: the background, %a"
        (if left = 0 then "chain ended" else "nothing hit")
        Color.pp color
  | Closed { terms; color; _ } ->
      Format.fprintf ppf "mix: %a = %a" pp_sum terms Color.pp color
  | Done color -> Format.fprintf ppf "done: %a" Color.pp color

open Raylab_geometry
open Raylab_scene

type t =
  | Cast of { ray : Ray.t; left : int }
  | Chain_ended of Color.t
  | Missed of Color.t
  | Nearest_hit of Hit.t
  | Faces_away of { light : int; cosine : float }
  | Shadow_ray of { light : int; ray : Ray.t }
  | Blocked of { light : int; by : int; t : float; point : Vec3.t }
  | Lit of {
      light : int;
      cosine : float;
      falloff : float;
      contribution : Color.t;
    }
  | Bounce of { ray : Ray.t; left : int }
  | Mixed of {
      emitted : Color.t;
      light : Color.t;
      diffused : Color.t;
      mirrored : Color.t;
      color : Color.t;
    }
  | Done of Color.t

let pp ppf = function
  | Cast { ray; left } ->
      Format.fprintf ppf "cast: %a, %d left in the chain" Ray.pp ray left
  | Chain_ended color ->
      Format.fprintf ppf "chain ended: the background, %a" Color.pp color
  | Missed color ->
      Format.fprintf ppf "nothing hit: the background, %a" Color.pp color
  | Nearest_hit hit ->
      Format.fprintf ppf "nearest hit: object %d, %a" hit.number Hit.pp hit
  | Faces_away { light; cosine } ->
      Format.fprintf ppf "light %d: faces away, cosine %a" light Number.pp
        cosine
  | Shadow_ray { light; ray } ->
      Format.fprintf ppf "shadow ray to light %d: %a" light Ray.pp ray
  | Blocked { light; by; t; point } ->
      Format.fprintf ppf "light %d: blocked by object %d, t = %a at %a" light
        by Number.pp t Vec3.pp point
  | Lit { light; cosine; falloff; contribution } ->
      Format.fprintf ppf "light %d: lit, cosine %a, fall-off %a, gives %a"
        light Number.pp cosine Number.pp falloff Color.pp contribution
  | Bounce { ray; left } ->
      Format.fprintf ppf "bounce: %a, %d left in the chain" Ray.pp ray left
  | Mixed { emitted; diffused; mirrored; color; _ } ->
      Format.fprintf ppf "mix: emitted %a + diffused %a + mirrored %a = %a"
        Color.pp emitted Color.pp diffused Color.pp mirrored Color.pp color
  | Done color -> Format.fprintf ppf "done: %a" Color.pp color

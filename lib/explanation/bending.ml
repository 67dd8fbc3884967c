open Raylab_geometry
open Raylab_expression
open Raylab_scene
open Raylab_tracer

let pf = Printf.sprintf
let degrees angle = pf "%g" (Float.round (10. *. angle) /. 10.)

(* Of the ray with the normal of the side from which it comes. *)
let incidence (e : Explain.t) { Hit.normal; _ } =
  let along = Vec3.dot (Ray.direction e.ray :> Vec3.t) (normal :> Vec3.t) in
  Arc.acos (Float.min 1. (Float.abs along))

(* From this angle on all is reflected. *)
let critical index { Hit.outside; _ } =
  Arc.asin (if outside then index else 1. /. index)

let is_glass index { Lobes.refractions; _ } =
  List.exists
    (fun { Lobes.index = i; fresnel; _ } ->
      i = index && Color.largest fresnel > 0.)
    refractions

let of_term e { Explain.hit; lobes; _ } (source : Event.source) =
  match source with
  | Background | Emitted | Diffused _ | Shine _ | Mirror _ -> None
  | Refraction { index; cosine; _ } when cosine = 0. ->
      Some
        (pf
           "totally reflected (%s degrees to the normal, and from %s on all \
            is)"
           (degrees (incidence e hit))
           (degrees (critical index hit)))
  | Refraction { index; cosine; _ } ->
      Some
        (pf "refracted %s %s (%s degrees to the normal become %s)"
           (if hit.outside then "into" else "out of")
           (if is_glass index lobes then "the glass" else "it")
           (degrees (incidence e hit))
           (degrees (Arc.acos cosine)))

let shares (source : Event.source) =
  match source with
  | Refraction { share; cosine; weight; _ }
    when cosine > 0. && Color.largest weight > 0. && share > 0. ->
      Some
        (pf "%s goes through, %s is mirrored"
           (Words.rough_percent (1. -. share))
           (Words.rough_percent share))
  | _ -> None

let of_hit (e : Explain.t) (h : Explain.surface_hit) =
  let sentence ({ source; _ } : Explain.term) =
    let says way =
      match (source, shares source) with
      | Refraction { index; _ }, Some shares when is_glass index h.lobes ->
          way ^ ": " ^ shares
      | _ -> way
    in
    Option.map says (of_term e h source)
  in
  List.filter_map sentence e.terms

let is_total ({ source; _ } : Explain.term) =
  match source with Refraction { cosine; _ } -> cosine = 0. | _ -> false

let whence (e : Explain.t) (next : Explain.t) =
  match next.role with
  | Primary -> ""
  | Refracted -> ", refracted"
  | Mirrored when List.exists is_total e.terms -> ", totally reflected"
  | Mirrored -> ", mirrored"

open Raylab_geometry
open Raylab_scene
open Raylab_tracer

type kind = Primary | Mirrored | Refracted | Unfollowed | Lit | Blocked

type ray = {
  kind : kind;
  number : int;
  ray : Ray.t;
  length : float;
  meets : int option;
  light : int option;
  tint : Color.t;
  words : string;
}

type hit = { number : int; point : Vec3.t; color : Color.t }
type t = { rays : ray list; hits : hit list }

let pf = Printf.sprintf

let name ?primitive (o : Object.t) number =
  match (primitive : Explain.primitive option) with
  | None -> pf "%s %d" (Shape.name o.shape) number
  | Some { index; object_; _ } ->
      pf "%s %d.%d" (Shape.name object_.shape) number index

let rec shadow_rays number light : Explain.verdict -> ray list = function
  | Faces_away _ | Outside _ | Lit { shadow_ray = None; _ } -> []
  | Mean { points; _ } -> List.concat_map (shadow_rays number light) points
  | Lit { shadow_ray = Some ray; through; _ } ->
      let length = Ray.reach ray in
      let words =
        pf (if length = infinity then "light %d" else "to light %d") light
      in
      let meets = None and light = Some light in
      let tint = Explain.tint through in
      [ { kind = Lit; number; ray; length; meets; light; tint; words } ]
  | Blocked { shadow_ray = ray; by; blocker; primitive; t = length; _ } ->
      let words = "blocked by " ^ name ?primitive blocker by in
      let meets = Some by and light = Some light and tint = Color.white in
      [ { kind = Blocked; number; ray; length; meets; light; tint; words } ]

(* The ray of [e], the [number]th of the chain. *)
let chain_ray number (e : Explain.t) =
  let kind =
    match e.role with
    | Primary -> Primary
    | Mirrored -> Mirrored
    | Refracted -> Refracted
  in
  let endless kind words =
    let meets = None and light = None and tint = Color.white in
    let length = infinity in
    { kind; number; ray = e.ray; length; meets; light; tint; words }
  in
  match e.outcome with
  | Missed -> endless kind "to the background"
  | Chain_ended -> endless Unfollowed "the chain has ended"
  | Too_faint -> endless Unfollowed "too faint to follow"
  | Hit { hit; object_; primitive; _ } ->
      let words =
        Format.asprintf "to %s, t = %a"
          (name ?primitive object_ hit.number)
          Number.pp hit.t
      in
      { (endless kind words) with length = hit.t; meets = Some hit.number }

let hit { Explain.hit = { number; point; _ }; _ } color =
  { number; point; color }

(* A loop: chains may be long. *)
let rec add film number rays hits = function
  | [] -> { rays = List.rev rays; hits = List.rev hits }
  | (e : Explain.t) :: others ->
      let rays = chain_ray number e :: rays in
      let rays, hits =
        match e.outcome with
        | Missed | Chain_ended | Too_faint -> (rays, hits)
        | Hit h ->
            let of_light { Explain.number = light; verdict; _ } =
              shadow_rays number light verdict
            in
            ( List.rev_append (List.concat_map of_light h.lights) rays,
              hit h (Film.encode film (Film.expose film e.color)) :: hits )
      in
      add film (number + 1) rays hits (Explain.next e @ others)

let of_rays film rays =
  let paths = List.map (fun e -> add film 1 [] [] [ e ]) rays in
  {
    rays = List.concat_map (fun path -> path.rays) paths;
    hits = List.concat_map (fun path -> path.hits) paths;
  }

let end_of { ray; length; _ } =
  if length = infinity then None else Some (Ray.at ray length)

let objects { rays; _ } =
  List.sort_uniq Int.compare (List.filter_map (fun ray -> ray.meets) rays)

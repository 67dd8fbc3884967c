open Raylab_geometry
open Raylab_expression

let vector numbers k =
  Vec3.make numbers.(3 * k) numbers.((3 * k) + 1) numbers.((3 * k) + 2)

let set numbers k { Vec3.x; y; z } =
  numbers.(3 * k) <- x;
  numbers.((3 * k) + 1) <- y;
  numbers.((3 * k) + 2) <- z

let direction v : Vec3.t option =
  Option.map (fun d -> (d : Direction.t :> Vec3.t)) (Direction.of_vec3 v)

let point (facets : Facets.t) triangle k =
  vector facets.points facets.corners.((3 * triangle) + (k mod 3))

(* The direction from one corner of a triangle to another. *)
let edge facets triangle k l =
  direction (Vec3.sub (point facets triangle l) (point facets triangle k))

let flat facets triangle =
  match (edge facets triangle 0 1, edge facets triangle 0 2) with
  | Some u, Some v -> direction (Vec3.cross u v)
  | _ -> None

(* Between unit vectors; the smallest angles too are exact so (W. Kahan, How
   futile are mindless assessments of roundoff in floating-point computation?,
   2006). *)
let angle u v =
  let apart = Vec3.length (Vec3.sub u v)
  and along = Vec3.length (Vec3.add u v) in
  2. *. Arc.atan2 apart along

(* Adds the normal of a triangle, weighted, to the sums at its corners. *)
let add_triangle (facets : Facets.t) places sums triangle =
  match flat facets triangle with
  | None -> ()
  | Some normal ->
      for k = 0 to 2 do
        let around u v =
          let weighted = Vec3.scale (angle u v) normal
          and place = places.(facets.corners.((3 * triangle) + k)) in
          set sums place (Vec3.add (vector sums place) weighted)
        in
        match
          (edge facets triangle k (k + 1), edge facets triangle k (k + 2))
        with
        | Some u, Some v -> around u v
        | _ -> ()
      done

let any_direction = Vec3.make 0. 1. 0.

let facets (f : Facets.t) =
  let places = Mesh_edges.places f in
  let sums = Array.make (Array.length f.points) 0. in
  for triangle = 0 to Facets.count f - 1 do
    add_triangle f places sums triangle
  done;
  let own = Array.length f.normals / 3 in
  let points = Array.length f.points / 3 in
  (* those of the file, the means, and one for each triangle without a mean *)
  let known = Array.append f.normals sums
  and more = ref []
  and count = ref 0 in
  let normalise k =
    match direction (vector known k) with
    | Some normal ->
        set known k normal;
        true
    | None -> false
  in
  let is_known = Array.init (own + points) normalise in
  let add_flat triangle =
    let { Vec3.x; y; z } =
      Option.value ~default:any_direction (flat f triangle)
    in
    more := [| x; y; z |] :: !more;
    incr count;
    own + points + !count - 1
  in
  let normal_of corner point =
    let written =
      if f.corner_normals = [||] then -1 else f.corner_normals.(corner)
    in
    let mean = own + places.(point) in
    if written >= 0 then written
    else if is_known.(mean) then mean
    else add_flat (corner / 3)
  in
  let corner_normals = Array.mapi normal_of f.corners in
  let normals = Array.concat (known :: List.rev !more) in
  { f with normals; corner_normals }

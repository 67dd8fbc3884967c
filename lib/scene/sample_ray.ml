open Raylab_geometry
open Raylab_expression

(* The point of the lens for sample [k], from its middle: area for area as the
   square of its coordinates. *)
let on_lens { Lens.aperture; _ } pixel k =
  let radius = aperture *. sqrt (Spread.lens pixel k)
  and angle = 360. *. Spread.lens' pixel k in
  (radius *. Degrees.cos angle, radius *. Degrees.sin angle)

(* Moves the origin of [ray], which looks through a pinhole, to that point, and
   turns it to where the pinhole sees the plane in focus. *)
let go_through_lens lens camera pixel k (ray : Raw_ray.t) =
  let focus = Option.value lens.Lens.focus ~default:camera.Camera.depth in
  let across, up = on_lens lens pixel k in
  let { Viewpoint.right; above; forward; _ } = camera.viewpoint in
  let open Vec3.Infix in
  let pinhole = Ray.of_raw ray in
  let along = Vec3.dot (Ray.direction pinhole :> Vec3.t) (forward :> Vec3.t)
  and aside = (across * (right :> Vec3.t)) + (up * (above :> Vec3.t)) in
  let sharp = Ray.at pinhole (focus /. along) in
  let origin = Ray.origin pinhole + aside in
  match Direction.of_vec3 (sharp - origin) with
  | None -> ()
  | Some direction ->
      let { Vec3.x; y; z } = (direction :> Vec3.t) in
      Raw_ray.set_origin ray origin.x origin.y origin.z;
      Raw_ray.set_direction ray x y z

let aim { Scene.camera; lens; film; _ } centres ~x ~y k (ray : Raw_ray.t) =
  let pixel = Spread.of_pixel ~x ~y in
  (if k = 0 then Camera.aim_at_centre camera centres ~x ~y ray
   else
     let dx = Spread.across pixel k and dy = Spread.down pixel k in
     Camera.aim camera ~x ~y ~dx ~dy ray);
  if film.samples > 1 && Lens.is_open lens then
    go_through_lens lens camera pixel k ray;
  ray.seed <- Spread.seed pixel k

let make scene ~x ~y k =
  let ray = Raw_ray.create () in
  aim scene Camera.no_centres ~x ~y k ray;
  Ray.of_raw ray

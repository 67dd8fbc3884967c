(* The hierarchy must answer as the plainest index does, shape for shape. *)

open Raylab_geometry
open Test_support

let register (ray : Ray.t) : Raw_ray.t =
  (Ray.of_raw (ray :> Raw_ray.t) :> Raw_ray.t)

let answers index rays =
  let { Query.nearest; blocked } = index () in
  List.map
    (fun ray ->
      let asked = register ray in
      let number = nearest asked in
      (number, asked.reach, blocked 0 (register ray)))
    rays

let shapes_and_rays sizes number =
  QCheck2.Gen.(
    pair
      (array_size sizes (Generate.shape number))
      (list_size (1 -- 30) (Generate.ray number)))

let agrees (shapes, rays) =
  answers (Bvh.index shapes) rays = answers (Query.brute_force shapes) rays

(* Corners and centres of a grid: many at the same distance, rays along faces
   of boxes. *)
let on_a_grid =
  QCheck2.Gen.(
    let cell = map float_of_int (-3 -- 3) in
    pair
      (array_size (0 -- 60)
         (map2
            (fun centre radius -> Shape.sphere ~centre ~radius)
            (Generate.vec3 cell)
            (oneofl [ 0.5; 1.; 2. ])))
      (list_size (1 -- 30) (Generate.ray cell)))

let holds name count gen = Property.holds name ~count gen agrees

let suite =
  ( "Bvh",
    [
      holds "as brute force" 500
        (shapes_and_rays QCheck2.Gen.(0 -- 80) Generate.everyday);
      holds "of many" 20
        (shapes_and_rays (QCheck2.Gen.pure 2000) Generate.everyday);
      holds "on a grid" 500 on_a_grid;
      holds "with numbers of any size" 1000
        (shapes_and_rays QCheck2.Gen.(0 -- 40) Generate.extreme);
    ] )

type t = {
  mutable ox : float;
  mutable oy : float;
  mutable oz : float;
  mutable dx : float;
  mutable dy : float;
  mutable dz : float;
  mutable reach : float;
  mutable seed : float;
  mutable share : float;
}

let create () =
  {
    ox = 0.;
    oy = 0.;
    oz = 0.;
    dx = 0.;
    dy = 0.;
    dz = 1.;
    reach = infinity;
    seed = 0.;
    share = 1.;
  }

let[@inline] set_origin ray x y z =
  ray.ox <- x;
  ray.oy <- y;
  ray.oz <- z

let[@inline] end_x ray = ray.ox +. (ray.reach *. ray.dx)
let[@inline] end_y ray = ray.oy +. (ray.reach *. ray.dy)
let[@inline] end_z ray = ray.oz +. (ray.reach *. ray.dz)

let[@inline] set_direction ray x y z =
  ray.dx <- x;
  ray.dy <- y;
  ray.dz <- z

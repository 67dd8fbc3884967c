open Raylab_geometry
open Raylab_scene

type t = {
  prepared : Prepared.t;
  surfaces : Surfaces.t;
  observe : (Event.t -> unit) option;
  finder : Finder.t;
  shadow_finder : Finder.t;
  tally : Tally.t;
  ray : Raw_ray.t;
  shadow_ray : Raw_ray.t;
  meeting : Meeting.t;
  spot : Spot.t;
  lobes : Raw_lobes.t;
  machines : Surface.machines option array;
  background : Background.reader;
  incidence : Light.incidence;
  light : Raw_color.t;
  color : Raw_color.t;
}

let create ?observe (prepared : Prepared.t) =
  let finder = prepared.index () in
  {
    prepared;
    surfaces = prepared.surfaces;
    observe;
    finder;
    shadow_finder =
      (match prepared.casters with
      | None -> finder
      | Some _ -> prepared.shadow_index ());
    tally = Tally.create ();
    ray = Raw_ray.create ();
    shadow_ray = Raw_ray.create ();
    meeting = Meeting.create ();
    spot = Spot.create ();
    lobes = Raw_lobes.create ();
    machines = Array.make (Array.length prepared.surfaces.patterned) None;
    background = Background.reader prepared.scene.background;
    incidence = Light.create_incidence ();
    light = Raw_color.create ();
    color = Raw_color.create ();
  }

let machines t row =
  if not (Surfaces.is_patterned row) then Surface.no_machines
  else
    let k = Surfaces.pattern row in
    match t.machines.(k) with
    | Some machines -> machines
    | None ->
        let machines = Surface.start t.surfaces.patterned.(k) in
        t.machines.(k) <- Some machines;
        machines

let load t (r : Ray.t) =
  let r = (r :> Raw_ray.t) in
  Raw_ray.set_origin t.ray r.ox r.oy r.oz;
  Raw_ray.set_direction t.ray r.dx r.dy r.dz;
  t.ray.reach <- r.reach;
  t.ray.seed <- r.seed

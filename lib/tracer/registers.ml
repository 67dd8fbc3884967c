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
  bounces : Bounces.t;
  incidence : Incidence.t;
  clear_finder : Finder.t option;
  passing : Raw_ray.t;
  shadow_spot : Spot.t;
  shadow_lobes : Raw_lobes.t;
  part : Raw_color.t;
  tint : Raw_color.t;
  mutable crossings : Event.crossing list;
  gives : Raw_color.t;
  mean : Raw_color.t;
  no_highlights : Raw_parts.t;
  shine : Shine.t;
  mean_shine : Shine.t;
  gives_shine : Shine.t;
  machines : Surface.machines option array;
  background : Background.reader;
  light : Raw_color.t;
  color : Raw_color.t;
}

let create ?observe (prepared : Prepared.t) =
  let finder = Index.ask prepared.index in
  {
    prepared;
    surfaces = prepared.surfaces;
    observe;
    finder;
    shadow_finder =
      (match prepared.casters with
      | None -> finder
      | Some _ -> Index.ask prepared.shadow_index);
    tally = Tally.create ();
    ray = Raw_ray.create ();
    shadow_ray = Raw_ray.create ();
    meeting = Meeting.create ();
    spot = Spot.create ();
    lobes = Raw_lobes.create ();
    bounces = Bounces.create ();
    incidence = Incidence.create ();
    clear_finder =
      Option.map
        (fun (clear : Prepared.clear) -> Index.ask clear.index)
        prepared.clear;
    passing = Raw_ray.create ();
    shadow_spot = Spot.create ();
    shadow_lobes = Raw_lobes.create ();
    part = Raw_color.create ();
    tint = Raw_color.create ();
    crossings = [];
    gives = Raw_color.create ();
    mean = Raw_color.create ();
    no_highlights = Raw_parts.create ~colors:1;
    shine = Shine.create ();
    mean_shine = Shine.create ();
    gives_shine = Shine.create ();
    machines = Array.make (Array.length prepared.surfaces.patterned) None;
    background = Background.reader prepared.scene.background;
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

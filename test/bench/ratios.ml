let minimum figure runs = Figures.minimum (List.map figure runs)
let median figure runs = Figures.median (List.map figure runs)

let render_one (trial : Trial.t) =
  minimum (fun (run : Measure.t) -> run.render.cpu) trial.one
  /. minimum (fun (run : Povray.t) -> run.trace.cpu) trial.povray_one

let render_many (trial : Trial.t) =
  minimum (fun (run : Measure.t) -> run.render.wall) trial.many
  /. minimum (fun (run : Povray.t) -> run.trace.wall) trial.povray_many

(* POV-Ray tells times in milliseconds: fewer than ten say too little. *)
let build (trial : Trial.t) =
  let bounding =
    minimum (fun (run : Povray.t) -> run.bounding.wall) trial.povray_one
  in
  if bounding < 0.01 then Float.nan
  else minimum (fun (run : Measure.t) -> run.build.wall) trial.one /. bounding

let render_wall = minimum (fun (run : Measure.t) -> run.render.wall)

let speed_up (trial : Trial.t) =
  render_wall trial.one /. render_wall trial.many

let words_per_ray (trial : Trial.t) =
  List.fold_left Float.max Float.neg_infinity
    (List.map
       (fun (run : Measure.t) -> run.words /. Measure.rays run)
       (trial.one @ trial.many))

let load (trial : Trial.t) =
  minimum (fun (run : Measure.t) -> run.load.wall) trial.one
  /. render_wall trial.one

let bytes_per_sphere (trial : Trial.t) =
  let peak (run : Measure.t) = Option.value run.peak ~default:Float.nan in
  minimum peak trial.one /. float_of_int trial.scene.spheres

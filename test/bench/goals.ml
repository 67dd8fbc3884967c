type verdict = Met | Missed | Not_measured
type t = { what : string; aim : string; reached : string; verdict : verdict }
type limit = At_most of float | At_least of float | Under of float

let is_met limit x =
  match limit with
  | At_most bound -> x <= bound
  | At_least bound -> x >= bound
  | Under bound -> x < bound

let is_worse limit x y =
  match limit with At_most _ | Under _ -> x > y | At_least _ -> x < y

let show_limit show = function
  | At_most bound -> "at most " ^ show bound
  | At_least bound -> "at least " ^ show bound
  | Under bound -> "under " ^ show bound

(* [goal what limit show figures] asks that each of the named [figures] keeps
   to [limit]. *)
let goal what limit show figures =
  let reached, verdict =
    match Figures.worst (is_worse limit) figures with
    | None -> ("-", Not_measured)
    | Some (name, x) ->
        ( Printf.sprintf "%s (%s)" (show x) name,
          if is_met limit x then Met else Missed )
  in
  { what; aim = show_limit show limit; reached; verdict }

let judge ~domains ~first_pixel (trials : Trial.t list) =
  let of_trials figure =
    List.map (fun (trial : Trial.t) -> (trial.scene.title, figure trial))
  in
  let random = List.filter (fun (trial : Trial.t) -> trial.scene.random) trials
  and million =
    List.filter
      (fun (trial : Trial.t) -> trial.scene.name = Scenes.million)
      trials
  in
  let ratio = Printf.sprintf "%.2f" in
  [
    goal "render, CPU time / POV-Ray's, 1 thread" (At_most 0.25) ratio
      (of_trials Ratios.render_one random);
    goal
      (Printf.sprintf "render, wall time / POV-Ray's, %d threads" domains)
      (At_most 0.25) ratio
      (of_trials Ratios.render_many random);
    goal "hierarchy, time / POV-Ray's, a million spheres" (At_most 0.4) ratio
      (of_trials Ratios.build million);
    goal
      (Printf.sprintf "speed-up, %d domains" domains)
      (At_least (0.9 *. float_of_int domains))
      ratio
      (of_trials Ratios.speed_up trials);
    goal "words allocated per ray" (Under 2.) (Printf.sprintf "%.1f")
      (of_trials Ratios.words_per_ray trials);
    goal "start to first pixel" (Under 0.05)
      (fun s -> Printf.sprintf "%.0f ms" (1000. *. s))
      [ ("first.scene", first_pixel) ];
    goal "parse + check / render, a million spheres" (At_most 1.5) ratio
      (of_trials Ratios.load million);
    goal "peak memory per sphere, a million spheres" (At_most 600.)
      (Printf.sprintf "%.0f bytes")
      (of_trials Ratios.bytes_per_sphere million);
  ]

open Show

type t = {
  machine : (string * string) list;
  plan : Trial.plan;
  first_pixel : float list;
  povray_empty : Povray.t list;
  trials : Trial.t list;
}

(* {1 Tables} *)

(* Minimum and, in brackets, median. *)
let time figure runs =
  if runs = [] then "-"
  else
    Printf.sprintf "%s (%s)"
      (milliseconds (Ratios.minimum figure runs))
      (milliseconds (Ratios.median figure runs))

let table trials groups =
  let columns = List.concat groups in
  let header = "scene" :: List.map fst columns in
  let row (trial : Trial.t) =
    trial.scene.title :: List.map (fun (_, cell) -> cell trial) columns
  in
  Table.to_string ~header (List.map row trials)

let first_run show (trial : Trial.t) =
  match trial.one with [] -> "-" | run :: _ -> show run

let first_povray show (trial : Trial.t) =
  match trial.povray_one with [] -> "-" | run :: _ -> show run

let tally show = first_run (fun run -> count (show run.tally))

let rays_per_second runs =
  let per_second (run : Measure.t) =
    -.(Measure.rays run /. run.render.wall /. 1e6)
  in
  decimals 2 (-.Ratios.minimum per_second runs)

let rendering { plan; trials; _ } =
  let wall = time (fun (run : Measure.t) -> run.render.wall) in
  let domains = Printf.sprintf "%d domains" plan.domains in
  table trials
    [
      [ ("1 domain, ms", fun trial -> wall trial.one) ];
      (if plan.domains = 1 then []
       else
         [
           (domains ^ ", ms", fun trial -> wall trial.many);
           ("speed-up", fun trial -> ratio (Ratios.speed_up trial));
         ]);
      [ ("Mrays/s, 1", fun trial -> rays_per_second trial.one) ];
      (if plan.domains = 1 then []
       else [ (domains, fun trial -> rays_per_second trial.many) ]);
      [ ("words/ray", fun trial -> decimals 1 (Ratios.words_per_ray trial)) ];
    ]

let against_povray { plan; povray_empty; trials; _ } =
  let overhead = Povray.overhead povray_empty in
  let ours_cpu = time (fun (run : Measure.t) -> run.render.cpu)
  and ours_wall = time (fun (run : Measure.t) -> run.render.wall)
  and cpu = time (fun (run : Povray.t) -> run.trace.cpu)
  and wall = time (fun (run : Povray.t) -> run.trace.wall)
  and check runs = milliseconds (Povray.trace_by_difference ~overhead runs) in
  table trials
    [
      [
        ("POV-Ray, 1 thread: CPU, ms", fun trial -> cpu trial.povray_one);
        ("(check)", fun trial -> check trial.povray_one);
        ("raylab", fun trial -> ours_cpu trial.one);
        ("ratio", fun trial -> ratio (Ratios.render_one trial));
      ];
      (if plan.domains = 1 then []
       else
         [
           ( Printf.sprintf "POV-Ray, %d threads: wall, ms" plan.domains,
             fun trial -> wall trial.povray_many );
           ("raylab", fun trial -> ours_wall trial.many);
           ("ratio", fun trial -> ratio (Ratios.render_many trial));
         ]);
    ]

let before_rendering { plan; trials; _ } =
  let load = time (fun (run : Measure.t) -> run.load.wall)
  and build = time (fun (run : Measure.t) -> run.build.wall)
  and parse = time (fun (run : Povray.t) -> run.parse.wall)
  and bounding = time (fun (run : Povray.t) -> run.bounding.wall) in
  table trials
    [
      [
        ("file, MB", fun trial -> megabytes (float_of_int trial.file_size));
        ("read, parse, check, ms", fun trial -> load trial.one);
        ("/ render", fun trial -> ratio (Ratios.load trial));
        ("build, ms", fun trial -> build trial.one);
      ];
      (if not plan.povray then []
       else
         [
           ("POV-Ray: parse, ms", fun trial -> parse trial.povray_one);
           ("bounding, ms", fun trial -> bounding trial.povray_one);
           ("build / bounding", fun trial -> ratio (Ratios.build trial));
         ]);
    ]

let memory { plan; trials; _ } =
  let peak runs =
    Ratios.minimum
      (fun (run : Measure.t) -> Option.value run.peak ~default:Float.nan)
      runs
  in
  table trials
    [
      [
        ("1 domain, MB", fun trial -> megabytes (peak trial.one));
        ( "bytes/sphere",
          (* fewer spheres weigh nothing beside the program *)
          fun trial ->
            if trial.scene.spheres < 10_000 then "-"
            else decimals 0 (Ratios.bytes_per_sphere trial) );
      ];
      (if plan.domains = 1 then []
       else
         [
           ( Printf.sprintf "%d domains, MB" plan.domains,
             fun trial -> megabytes (peak trial.many) );
         ]);
    ]

let rays { plan; trials; _ } =
  table trials
    [
      [
        ("primary", tally (fun tally -> tally.primary));
        ("reflected", tally (fun tally -> tally.reflected));
        ("shadow", tally (fun tally -> tally.shadow));
        ("hits", tally (fun tally -> tally.hits));
        ("blocked", tally (fun tally -> tally.blocked));
      ];
      (if not plan.povray then []
       else
         [
           ( "POV-Ray: primary + reflected",
             first_povray (fun run -> count run.rays) );
           ("shadow", first_povray (fun run -> count run.shadow_rays));
         ]);
    ]

let goals { plan; first_pixel; trials; _ } =
  let row { Goals.what; aim; reached; verdict } =
    let verdict =
      match verdict with
      | Met -> "met"
      | Missed -> "missed"
      | Not_measured -> "not measured"
    in
    [ what; aim; reached; verdict ]
  in
  Table.to_string
    ~header:[ "goal"; "aim"; "reached (worst scene)"; "" ]
    (List.map row
       (Goals.judge ~domains:plan.domains
          ~first_pixel:(Figures.minimum first_pixel)
          trials))

(* {1 The page} *)

let introduction { plan; _ } =
  Printf.sprintf
    "Written by `dune exec --profile release test/bench/bench.exe -- --output \
     FILE`.\n\n\
     Each scene is measured %d times, each time in a new process, raylab and \
     POV-Ray in turn.\n\
     Times are the minimum and, in brackets, the median, in milliseconds of \
     the wall clock\n\
     unless it says CPU; ratios are of minima. All pictures have 640 x 480 \
     pixels, no antialiasing.\n\n"
    plan.runs

let sections ({ plan; _ } as results) =
  let povray section = if plan.povray then [ section ] else [] in
  [
    ("Goals", goals results, "");
    ( "Rendering",
      rendering results,
      "Words are those that all domains allocated while rendering." );
  ]
  @ povray
      ( "Rendering against POV-Ray",
        against_povray results,
        Printf.sprintf
          "POV-Ray's times are its own trace times: no start-up, parsing, \
           bounding or writing.\n\
           The check is the processor time of the whole process less parsing, \
           bounding and the\n\
           %s ms that it takes beside them for an empty scene."
          (milliseconds (Povray.overhead results.povray_empty)) )
  @ [
      ( "Before rendering",
        before_rendering results,
        "Build is everything between the checked scene and the first ray." );
      ( "Peak memory",
        memory results,
        "Of a process that reads, builds and renders the one scene." );
      ( "Rays",
        rays results,
        if plan.povray then
          "POV-Ray traces the same rays, give or take a few that graze an \
           edge. Where a chain of\n\
           rays ends, raylab shows the background and POV-Ray black."
        else "" );
    ]

let to_markdown results =
  let first_pixel =
    Printf.sprintf
      "A process that renders only the first row of `scenes/first.scene`, \
       from its start to its end: %s ms.\n\n"
      (time Fun.id results.first_pixel)
  in
  String.concat ""
    ([ "# How fast raylab is\n\n"; introduction results ]
    @ List.map
        (fun (name, value) -> Printf.sprintf "- %s: %s\n" name value)
        results.machine
    @ [ "\n" ]
    @ List.map
        (fun (title, table, note) ->
          Printf.sprintf "## %s\n\n%s\n%s" title table
            (if note = "" then "" else note ^ "\n\n"))
        (sections results)
    @ [ "## Start to first pixel\n\n"; first_pixel ])

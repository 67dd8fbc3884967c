open Raylab_source
open Raylab_scene

let points_of_one = 1_000
let points_of_all = 200_000

(* Objects with one surface, one after another. *)
let groups (scene : Scene.t) =
  let primitives (o : Object.t) =
    match o.primitives with [||] -> [ o ] | some -> Array.to_list some
  in
  let add groups (o : Object.t) =
    match groups with
    | (surface, objects) :: rest when surface == o.surface ->
        (surface, o :: objects) :: rest
    | _ -> (o.surface, [ o ]) :: groups
  in
  List.concat_map primitives scene.objects
  |> List.filter (fun (o : Object.t) -> Surface.has_patterns o.surface)
  |> List.fold_left add []
  |> List.rev_map (fun (surface, objects) -> (surface, List.rev objects))

let first_failure evaluate points =
  Seq.find_map
    (fun point ->
      match evaluate point with
      | () -> None
      | exception Pattern.Failed failure -> Some failure)
    points

let of_group ~points (surface, (objects : Object.t list)) =
  let machines = Surface.start (Surface.ready surface) in
  let each = Int.max 1 (points / List.length objects) in
  let of_object (o : Object.t) =
    first_failure
      (fun point ->
        ignore (Surface.resolve machines surface point : Surface.t))
      (Own_points.of_shape each o.shape)
  in
  List.find_map of_object objects

let of_background background =
  let reader = Background.reader background in
  match (background : Background.t) with
  | Plain _ -> None
  | Varying _ ->
      first_failure
        (fun direction ->
          ignore (Background.read_at reader direction : Color.t))
        (Own_points.directions points_of_one)

let error sources (failure : Pattern.failure) =
  let message, lines = Pattern.told (Sources.table sources) failure in
  Scene_error.make sources failure.fault.span message
    ~advice:(String.concat "\n" lines)

let errors sources scene =
  let groups = groups scene in
  let count = Int.max 1 (List.length groups) in
  let points = Int.max 1 (Int.min points_of_one (points_of_all / count)) in
  let failures =
    Option.to_list (of_background scene.background)
    @ List.filter_map (of_group ~points) groups
  in
  (* one mistake is told once *)
  let is_new (told : Pattern.failure list) (failure : Pattern.failure) =
    let same (other : Pattern.failure) =
      other.fault.span = failure.fault.span
    in
    not (List.exists same told)
  in
  List.fold_left
    (fun told failure -> if is_new told failure then failure :: told else told)
    [] failures
  |> List.rev_map (error sources)

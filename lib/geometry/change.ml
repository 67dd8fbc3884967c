type modifier =
  | Scaled of float
  | Stretched of Vec3.t
  | Rotated of { axis : Direction.t; angle : float; sin : float; cos : float }
  | Translated of Vec3.t

type t = {
  modifiers : modifier list;
  similarity : Similarity.t option;
  affine : Affine.t Lazy.t;
}

let require_finite name v =
  if not (Vec3.is_finite v) then
    invalid_arg (Format.asprintf "%s must be finite, not %a" name Vec3.pp v)

let similarity_of = function
  | Scaled k ->
      Number.require Positive "the factor" k;
      Some (Similarity.scaled k)
  | Rotated { axis; angle; sin; cos } ->
      Number.require Finite "the angle" angle;
      Some (Similarity.rotated ~axis ~sin ~cos)
  | Translated way ->
      require_finite "the way" way;
      Some (Similarity.translated way)
  | Stretched ({ x; y; z } as factors) ->
      require_finite "the factors" factors;
      if x = 0. || y = 0. || z = 0. then invalid_arg "a factor must not be 0";
      if x = y && y = z && x > 0. then Some (Similarity.scaled x) else None

let affine_of = function
  | Scaled k -> Affine.stretched (Vec3.make k k k)
  | Stretched factors -> Affine.stretched factors
  | Rotated { axis; sin; cos; _ } -> Affine.rotated ~axis ~sin ~cos
  | Translated way -> Affine.translated way

(* From the last modifier to the first: what groups do to all that is in them is
   worked out once. *)
let affine_before affine modifiers =
  List.fold_left
    (fun after modifier -> Affine.compose after (affine_of modifier))
    affine (List.rev modifiers)

let of_modifiers modifiers =
  let add before modifier =
    match (similarity_of modifier, before) with
    | Some similarity, Some before ->
        Some (Similarity.compose similarity before)
    | _ -> None
  in
  {
    modifiers;
    similarity = List.fold_left add (Some Similarity.identity) modifiers;
    affine = lazy (affine_before Affine.identity modifiers);
  }

let identity = of_modifiers []
let share change = ignore (Lazy.force change.affine : Affine.t)

let compose second first =
  let modifiers = first.modifiers @ second.modifiers in
  {
    modifiers;
    similarity =
      (match (second.similarity, first.similarity) with
      | Some second, Some first -> Some (Similarity.compose second first)
      | _ -> None);
    affine =
      lazy
        (* not one within the other: chains of changes may be long *)
        (if Lazy.is_val second.affine then
           affine_before (Lazy.force second.affine) first.modifiers
         else affine_before Affine.identity modifiers);
  }

let modifiers change = change.modifiers
let similarity change = change.similarity
let affine change = Lazy.force change.affine

(* {1 What is written} *)

let name = function
  | Scaled _ -> "scaled"
  | Stretched _ -> "stretched"
  | Rotated _ -> "rotated"
  | Translated _ -> "translated"

let parameters : modifier -> (string * Parameter.t) list = function
  | Scaled k -> [ ("factor", Number k) ]
  | Stretched factors -> [ ("factors", Parameter.of_vec3 factors) ]
  | Rotated { axis; angle; _ } ->
      [ ("axis", Parameter.of_vec3 (axis :> Vec3.t)); ("angle", Number angle) ]
  | Translated way -> [ ("way", Parameter.of_vec3 way) ]

let pp_with pp_number ppf =
  List.iter (fun modifier ->
      Format.fprintf ppf " %s" (name modifier);
      List.iter
        (fun (_, parameter) ->
          Format.fprintf ppf " %a" (Parameter.pp_with pp_number) parameter)
        (parameters modifier))

open Raylab_tracer

let pf = Printf.sprintf

type blocker = { by : int; name : string }

type t = {
  seen : int;
  points : int;
  hidden : (blocker * int) list;
  behind : int;
}

let blocker by o place = { by; name = Naming.by_number by o place }

let make points =
  let add t : Explain.verdict -> t = function
    | Lit _ | Mean _ -> { t with seen = t.seen + 1 }
    | Faces_away _ | Outside _ -> { t with behind = t.behind + 1 }
    | Blocked { by; blocker = o; place; _ } ->
        let b = blocker by o place in
        let n = Option.value (List.assoc_opt b t.hidden) ~default:0 in
        { t with hidden = (b, n + 1) :: List.remove_assoc b t.hidden }
  in
  let points_of = List.length points in
  let none = { seen = 0; points = points_of; hidden = []; behind = 0 } in
  let t = List.fold_left add none points in
  let by_number (a, _) (b, _) = Int.compare a.by b.by in
  { t with hidden = List.sort by_number t.hidden }

(* {1 In words} *)

let names hidden = Words.list (List.map (fun (b, _) -> b.name) hidden)

let hides t what =
  let verb = match t.hidden with [ _ ] -> "hides" | _ -> "hide" in
  pf "%s %s %s" (names t.hidden) verb what

let hides_some t =
  pf "%s and %d %s behind it"
    (hides t (string_of_int (t.points - t.seen - t.behind)))
    t.behind
    (if t.behind = 1 then "is" else "are")

let others ~exact t =
  match t.hidden with
  | [] -> "the others are behind it"
  | _ when t.behind = 0 -> hides t "the others"
  | _ -> if exact then hides_some t else hides t "others"

let to_string t =
  match t with
  | { seen; points = 1; _ } when seen = 1 -> "its point is seen"
  | { seen; points; _ } when seen = points ->
      pf "all %d points are seen" points
  | { seen; points; _ } when seen > 0 ->
      pf "%d of %d points are seen, while %s" seen points
        (others ~exact:true t)
  | { hidden = []; _ } -> "the surface faces away"
  | { behind = 0; points; _ } ->
      "no point is seen, since " ^ hides t (if points = 1 then "it" else "all")
  | _ -> "no point is seen, since " ^ hides_some t

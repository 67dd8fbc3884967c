open Raylab_source

(* {1 Names} *)

(* The steps of a relative path, without detours; [None] if it leaves the folder
   in which it starts. *)
let steps path =
  let step before name =
    match (before, name) with
    | before, ("" | ".") -> before
    | Some (_ :: before), ".." -> Some before
    | (Some [] | None), ".." -> None
    | Some before, name -> Some (name :: before)
    | None, _ -> None
  in
  if not (Filename.is_relative path) then None
  else
    String.split_on_char '/' path
    |> List.fold_left step (Some [])
    |> Option.map List.rev

let included = "included"

let belongs_to_job name =
  List.mem name (included :: Job.scene :: (Job.folders @ Job.names))

let own_name ~main ~taken number path =
  let folder = Filename.dirname main in
  let relative = Option.value ~default:path (Access.below folder path) in
  match steps relative with
  | Some (first :: _ as names)
    when (not (belongs_to_job first))
         && not (List.mem (String.concat "/" names) taken) ->
      String.concat "/" names
  | _ ->
      String.concat "/"
        [ included; string_of_int number; Filename.basename path ]

(* [(path, name)] of each file *)
let names sources =
  match Sources.paths sources with
  | [] -> []
  | main :: others ->
      let name (number, named) path =
        let taken = List.map snd named in
        let name = own_name ~main ~taken number path in
        (number + 1, (path, name) :: named)
      in
      snd (List.fold_left name (1, [ (main, Job.scene) ]) others)

(* {1 Texts} *)

let rec relative ~from target =
  match (from, target) with
  | a :: from, b :: (_ :: _ as target) when a = b -> relative ~from target
  | from, target -> String.concat "/" (List.map (fun _ -> "..") from @ target)

let folder name =
  match List.rev (String.split_on_char '/' name) with
  | [] -> []
  | _ :: folders -> List.rev folders

(* What the file called [by] calls the file [name], where it says [written]. *)
let reference ~by ~name written =
  let path = String.concat "/" (folder by @ [ written ]) in
  if Filename.is_relative written && steps path = steps name then written
  else relative ~from:(folder by) (String.split_on_char '/' name)

let copy names named { Sources.path; base; text } =
  let by = List.assoc path names in
  let inside ({ Span.start; _ }, _) =
    base <= start && start <= base + String.length text
  in
  let by_start (a, _) (b, _) = Int.compare a.Span.start b.Span.start in
  let places = List.sort by_start (List.filter inside named) in
  let piece (at, pieces) ({ Span.start; stop }, other) =
    let start = start - base + 1 and stop = stop - base - 1 in
    let written = String.sub text start (stop - start) in
    let name = reference ~by ~name:(List.assoc other names) written in
    (stop, name :: String.sub text at (start - at) :: pieces)
  in
  let at, pieces = List.fold_left piece (0, []) places in
  let rest = String.sub text at (String.length text - at) in
  (by, String.concat "" (List.rev (rest :: pieces)))

let make sources named =
  let names = names sources in
  let attached ({ path; bytes } : Sources.attached) =
    (List.assoc path names, bytes)
  in
  List.map (copy names named) (Sources.files sources)
  @ List.map attached (Sources.attached sources)

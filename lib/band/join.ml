open Raylab_picture

type t = { whole : Band.whole; pieces : Band_file.t Cover.piece list }

let whole join = join.whole
let ( let* ) = Result.bind

(* {1 Folders} *)

(* What is being written has a name that starts with a dot. *)
let in_folder folder =
  match Sys.readdir folder with
  | names ->
      Array.to_list names
      |> List.filter (fun name -> name.[0] <> '.')
      |> List.sort String.compare
      |> List.map (Filename.concat folder)
      |> Result.ok
  | exception Sys_error reason -> Error [ reason ]

let rec files = function
  | [] -> Ok []
  | path :: rest ->
      let* here =
        if Sys.file_exists path && Sys.is_directory path then in_folder path
        else Ok [ path ]
      in
      let* others = files rest in
      Ok (here @ others)

(* {1 Checking} *)

let none_or_errors value = function [] -> Ok value | errors -> Error errors

let check_files paths =
  let files, errors =
    List.partition_map
      (fun path ->
        match Band_file.check path with
        | Ok file -> Left file
        | Error message -> Right message)
      paths
  in
  none_or_errors files errors

let check_wholes whole one files =
  let differing file =
    Band.difference whole (Band_file.band file).whole
    |> Option.map
         (Printf.sprintf "%s and %s are not of one picture: %s"
            (Band_file.path one) (Band_file.path file))
  in
  none_or_errors () (List.filter_map differing files)

let check_missing missing =
  let rows (first, last) =
    if first = last then Printf.sprintf "row %d is missing" first
    else Printf.sprintf "rows %d-%d are missing" first last
  in
  none_or_errors () (List.map rows missing)

(* [difference ~width piece file] is the first row at which [file] differs from
   [piece], which has all of its rows [piece.first] to [piece.last]. *)
let difference ~width (piece : _ Cover.piece) file =
  Band_file.with_rows piece.part (fun rows ->
      Band_file.with_rows file (fun others ->
          let differs first =
            not (Bytes.equal (rows ~first ~count:1) (others ~first ~count:1))
          in
          let in_piece (first, count) =
            if Bytes.equal (rows ~first ~count) (others ~first ~count) then
              None
            else Seq.find differs (Seq.take count (Seq.ints first))
          in
          Seq.find_map in_piece
            (Rows.pieces ~width ~first:piece.first ~last:piece.last)))

(* Bands that agree with the pieces agree with each other. *)
let check_overlaps width pieces files =
  let check file =
    let { Band.first; last; _ } = Band_file.band file in
    Cover.within ~first ~last pieces
    |> List.filter (fun (piece : _ Cover.piece) -> piece.part != file)
    |> List.filter_map (fun (piece : _ Cover.piece) ->
           difference ~width piece file
           |> Option.map
                (Printf.sprintf "%s and %s overlap, and differ in row %d"
                   (Band_file.path piece.part)
                   (Band_file.path file)))
  in
  none_or_errors () (List.concat_map check files)

let check paths =
  let* files = check_files paths in
  match files with
  | [] -> Error [ "there are no bands to join" ]
  | one :: others ->
      let whole = (Band_file.band one).whole in
      let* () = check_wholes whole one others in
      let piece file =
        let { Band.first; last; _ } = Band_file.band file in
        { Cover.part = file; first; last }
      in
      let pieces, missing =
        Cover.pieces ~height:whole.height (List.map piece files)
      in
      let* () = check_missing missing in
      let* () =
        try check_overlaps whole.width pieces files
        with Band_file.Unreadable message -> Error [ message ]
      in
      Ok { whole; pieces }

(* {1 Writing} *)

let pixels { whole = { width; height; _ }; pieces } =
  let iter ~lowest_first f =
    List.iter
      (fun { Cover.part; first; last } ->
        Band_file.with_rows part
          (Rows.iter ~lowest_first ~width ~first ~last (fun rgb ->
               f rgb 0 (Bytes.length rgb))))
      (if lowest_first then List.rev pieces else pieces)
  in
  { Pixels.width; height; label = None; iter }

type failure = Unreadable of string | Unwritable of string

let failing written =
  match written () with
  | Ok result -> Ok result
  | Error message -> Error (Unwritable message)
  | exception Band_file.Unreadable message -> Error (Unreadable message)

let save join format ~path =
  failing (fun () -> Picture_file.save_pixels format ~path (pixels join))

let output join format channel =
  failing (fun () -> Picture_file.output_pixels format channel (pixels join))

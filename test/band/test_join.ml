open Raylab_tracer
open Raylab_picture
open Raylab_band
open Test_support

let in_folder folder = Filename.concat folder

let join paths format ~path =
  match Join.check paths with
  | Error messages -> Alcotest.fail (String.concat "\n" messages)
  | Ok join -> (
      match Join.save join format ~path with
      | Ok _ -> Sample.read path
      | Error (Unreadable message | Unwritable message) ->
          Alcotest.fail message)

let at_once picture format ~path =
  match Picture_file.save format ~path picture with
  | Ok _ -> Sample.read path
  | Error message -> Alcotest.fail message

(* {1 Any split} *)

type split = {
  size : int * int;
  bands : (int * int * Picture_file.format) list;  (** in the order given *)
  out : Picture_file.format;
}

let any_split =
  let open QCheck2.Gen in
  let format = oneofl Sample.formats in
  let* width = int_range 1 12 and* height = int_range 1 12 and* out = format in
  let* cuts = list_size (int_bound 3) (int_range 1 height) in
  let cuts = List.sort_uniq compare ((0 :: cuts) @ [ height ]) in
  let rec bands = function
    | first :: (next :: _ as rest) -> (first, next - 1) :: bands rest
    | _ -> []
  in
  let row = int_bound (height - 1) in
  let* more = list_size (int_bound 2) (pair row row) in
  let more = List.map (fun (a, b) -> (min a b, max a b)) more in
  let with_format (first, last) = map (fun f -> (first, last, f)) format in
  let* bands = flatten_l (List.map with_format (bands cuts @ more)) in
  let* bands = shuffle_l bands in
  return { size = (width, height); bands; out }

let print { size = width, height; bands; out } =
  let name f = fst (List.find (fun (_, g) -> f = g) Picture_file.formats) in
  let band (a, b, f) = Printf.sprintf "%d-%d%s" a b (name f) in
  Printf.sprintf "%dx%d %s to %s" width height
    (String.concat " " (List.map band bands))
    (name out)

let is_whole { size = width, height; bands; out } =
  let same = ref false in
  Sample.in_new_folder
    (fun folder ->
      let picture = Sample.picture ~width ~height in
      let save k (first, last, format) =
        let path = in_folder folder (string_of_int k) in
        Sample.save format path picture ~first ~last;
        path
      in
      let paths = List.mapi save bands in
      let path = in_folder folder "out" in
      same := join paths out ~path = at_once picture out ~path)
    ();
  !same

(* Rows of more than a piece, so that there are several. *)
let test_pieces folder =
  let picture = Sample.picture ~width:150_001 ~height:7 in
  List.iter
    (fun format ->
      let a = in_folder folder "a" and b = in_folder folder "b" in
      Sample.save format a picture ~first:0 ~last:4;
      Sample.save format b picture ~first:3 ~last:6;
      List.iter
        (fun out ->
          let path = in_folder folder "out" in
          Alcotest.(check bool)
            "same" true
            (join [ b; a ] out ~path = at_once picture out ~path))
        Sample.formats)
    Sample.formats

(* {1 Refusals} *)

let picture = Sample.picture ~width:4 ~height:10
let whole = Sample.whole ~width:4 ~height:10

let check_refused what expected folder paths =
  match Join.check paths with
  | Ok _ -> Alcotest.failf "%s: joined" what
  | Error messages ->
      (* without the folder, whose name is another every time *)
      let short word =
        if String.starts_with ~prefix:folder word then Filename.basename word
        else word
      in
      let short message =
        String.split_on_char ' ' message |> List.map short |> String.concat " "
      in
      Alcotest.(check (list string)) what expected (List.map short messages)

let test_missing folder =
  let save name first last =
    let path = in_folder folder name in
    Sample.save Ppm path picture ~first ~last;
    path
  in
  check_refused "gaps"
    [ "row 2 is missing"; "rows 5-6 are missing" ]
    folder
    [ save "c" 7 9; save "a" 0 1; save "b" 3 4 ];
  check_refused "none" [ "there are no bands to join" ] folder []

let test_foreign folder =
  let save name whole =
    let path = in_folder folder name in
    Sample.save ~whole Bmp path picture ~first:0 ~last:4;
    path
  in
  let a = save "a" whole
  and scene = save "scene" { whole with scene = Digest.string "b" }
  and size = save "size" { whole with height = 11 }
  and grey = save "grey" { whole with grey = true } in
  check_refused "others"
    [
      "a and scene are not of one picture: the scenes differ";
      "a and size are not of one picture: the sizes differ, 4x10 and 4x11";
      "a and grey are not of one picture: one is grey";
    ]
    folder [ a; scene; size; grey ]

(* Another picture of the same scene differs in all rows; [b] in one. *)
let test_differing folder =
  let other = Sample.rows picture ~first:0 ~last:9 in
  Bytes.set (Picture.to_rgb other) ((3 * 4 * 6) + 5) '!';
  let save name picture first last =
    let path = in_folder folder name in
    Sample.save Png path picture ~first ~last;
    path
  in
  let a = save "a" picture 0 7 in
  check_refused "in one row"
    [ "a and b overlap, and differ in row 6" ]
    folder
    [ a; save "b" other 4 9 ];
  Alcotest.(check bool)
    "elsewhere" true
    (Result.is_ok (Join.check [ a; save "b" other 7 9 ]))

let suite =
  ( "Join",
    [
      Property.holds "any split is the whole" ~count:200 ~print any_split
        is_whole;
      Sample.test "piece by piece" test_pieces;
      Sample.test "missing rows" test_missing;
      Sample.test "bands of other pictures" test_foreign;
      Sample.test "overlaps that differ" test_differing;
    ] )

type t = {
  words : string;
  anchor : Drawing.anchor;
  size : float;
  ink : int;
  places : Drawing.point list;
  reach : float;
}

let make ?(anchor = Drawing.Start) ?(size = 12.) ?(ink = 0x222222)
    ?(reach = 60.) places words =
  { words; anchor; size; ink; places; reach }

(* The usual fonts take less than 0.6 of their size a letter, on average, and a
   few pixels more for a digit or two. *)
let letter = 0.6
let rim = 2.

let box { words; anchor; size; _ } (x, y) =
  let width = letter *. size *. float_of_int (String.length words) in
  let left =
    match anchor with
    | Start -> x
    | Middle -> x -. (width /. 2.)
    | End -> x -. width
  in
  {
    Rectangle.left = left -. rim;
    right = left +. width +. rim;
    top = y -. (Drawing.ascent *. size) -. rim;
    bottom = y +. (0.25 *. size) +. rim;
  }

(* {1 Room} *)

let step = 4.

(* Ways to go from where a label should stand, the shortest first. *)
let ways =
  let most = 20 in
  let range = List.init ((2 * most) + 1) (fun k -> k - most) in
  let ways = List.concat_map (fun j -> List.map (fun i -> (i, j)) range) range
  and squared (i, j) = (i * i) + (j * j) in
  List.stable_sort (fun a b -> Int.compare (squared a) (squared b)) ways
  |> List.map (fun (i, j) -> (step *. float_of_int i, step *. float_of_int j))

let shift (x, y) (dx, dy) = (x +. dx, y +. dy)

(* [places panel label] is where [label] may stand. *)
let places panel label =
  let into_panel place =
    shift place (Rectangle.way_into panel (box label place))
  in
  match List.map into_panel label.places with
  | [] -> Seq.empty
  | first :: _ as places ->
      let is_near (dx, dy) = Float.hypot dx dy <= label.reach in
      List.to_seq ways |> Seq.take_while is_near
      |> Seq.map (shift first)
      |> Seq.append (List.to_seq places)

let draw { words; anchor; size; ink; _ } place =
  Drawing.text ~anchor ~size ~ink place words

let arrange panel ~busy labels =
  let is_free taken box =
    Rectangle.holds panel box
    && not (List.exists (Rectangle.overlap box) taken)
  in
  let add (taken, drawn) label =
    let places = places panel label in
    let room taken = Seq.find (fun p -> is_free taken (box label p)) places in
    let place =
      match room (busy @ taken) with None -> room taken | place -> place
    in
    match place with
    | None -> (taken, drawn)
    | Some place -> (box label place :: taken, draw label place :: drawn)
  in
  List.rev (snd (List.fold_left add ([], []) labels))

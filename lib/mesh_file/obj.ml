open Growing

type reader = { words : Words.t; mesh : Builder.t; corner : Ints.t }

let unused { words; mesh; _ } what =
  Builder.unused mesh (Words.place words) what

let triple { words; _ } =
  let x = Words.next_number words "the x" in
  let y = Words.next_number words "the y" in
  let z = Words.next_number words "the z" in
  (x, y, z)

(* A fourth number is a weight, for curves only; six or seven have a colour. *)
let point reader =
  let { words; mesh; _ } = reader in
  let x, y, z = triple reader in
  Builder.point mesh (Words.place words) x y z;
  let rec count n = if Words.next words then count (n + 1) else n in
  if count 0 >= 3 then unused reader "colours of points"

let normal reader =
  let x, y, z = triple reader in
  Builder.normal reader.mesh (Words.place reader.words) x y z

(* The place from 0 of what is written as [index], where [count] are known. *)
let place words what index count =
  if index = 0 then
    Fault.fail (Words.place words) "%s counts from 1, and from -1 backwards"
      (Words.text words)
  else if index > 0 then index - 1
  else if -index <= count then count + index
  else
    Fault.fail (Words.place words) "%s counts back beyond the first %s"
      (Words.text words) what

let corner { words; mesh; corner } =
  Words.integers words ~separator:'/' corner;
  let given k =
    if k < Ints.length corner then Ints.get corner k else Words.missing
  in
  if given 0 = Words.missing || Ints.length corner > 3 then
    Fault.fail (Words.place words)
      "%s is no corner: it is a point, point/texture, point//normal or \
       point/texture/normal"
      (Words.text words);
  let point = place words "point" (given 0) (Builder.points mesh) in
  let normal =
    if given 2 = Words.missing then -1
    else place words "normal" (given 2) (Builder.normals mesh)
  in
  Builder.corner mesh ~point ~normal

let face reader =
  let { words; mesh; _ } = reader in
  let place = Words.place words in
  while Words.next words do
    corner reader
  done;
  Builder.end_face mesh place

let unused_words =
  [
    ([ "usemtl"; "mtllib"; "usemap"; "maplib" ], "materials");
    ([ "l" ], "lines");
    ([ "p" ], "points that are no corners");
    ( [ "cstype"; "deg"; "bmat"; "step"; "curv"; "curv2"; "surf"; "vp" ],
      "curves and curved surfaces" );
  ]

(* Names, groups, and what goes with words above. *)
let passed_over =
  [ "vt"; "g"; "o"; "s"; "mg"; "parm"; "trim"; "hole"; "scrv"; "sp"; "end" ]
  @ [ "con"; "bevel"; "c_interp"; "d_interp"; "lod"; "shadow_obj" ]
  @ [ "trace_obj"; "ctech"; "stech"; "call"; "csh" ]

let statement reader =
  let is = Words.is reader.words in
  if is "v" then point reader
  else if is "f" || is "fo" then face reader
  else if is "vn" then normal reader
  else
    match List.find_opt (fun (ws, _) -> List.exists is ws) unused_words with
    | Some (_, what) -> unused reader what
    | None ->
        if not (List.exists is passed_over) then
          unused reader ("lines that begin with " ^ Words.text reader.words)

(* A statement may leave words of its line, of which nobody asks. *)
let rec rest words = if Words.next words then rest words

let read ~most text =
  let reader =
    {
      words = Words.start text;
      mesh = Builder.create ~most ~counted_from:1;
      corner = Ints.create ();
    }
  in
  let rec lines () =
    if Words.next reader.words then statement reader;
    rest reader.words;
    if Words.next_line reader.words then lines ()
  in
  lines ();
  reader.mesh

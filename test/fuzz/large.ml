open Raylab_language

let header = "imWidth 4 imHeight 3 canvWidth 8 canvHeight 6 depth 5\n"
let ball = "sphere 0 0 6 1 "

let times text n =
  let length = String.length text in
  String.init (n * length) (fun k -> text.[k mod length])

let texts =
  let after_header ?(start = "") ?(stop = "") text =
    fun n -> header ^ start ^ times text n ^ stop
  in
  [
    ("nested mixes", after_header ~start:ball "mixed 1 " ~stop:"reflective");
    ("nested mixes without end", after_header ~start:ball "mixed 1 ");
    ("nested mixes in error", after_header ~start:ball "mixed 1 " ~stop:"x");
    ( "nested mixes with a wrong weight",
      after_header ~start:ball "mixed 1 " ~stop:"mixed -1 reflective" );
    ( "nested mixes of two",
      after_header ~start:ball "mixed 1 diffusive red .5 " ~stop:"reflective" );
    ( "a mix of many parts, as deep as may be",
      after_header ~start:(ball ^ times "mixed 1 " 999 ^ "mixed")
        " 1 luminous red" );
    ( "a mix of many parts",
      after_header ~start:(ball ^ "mixed") " 1 luminous red" );
    ( "many weights in error",
      after_header ~start:(ball ^ "mixed") " -1 reflective" );
    ("many lights", after_header ~start:"lights\n" "spherical 1 red 0 3 3\n");
    ("many objects", after_header "sphere 0 0 6 1 diffusive white\n");
    ("many settings", times "depth 1 imWidth 2 ");
    ("empty lines", times "\n");
    ("lines of Windows", times "\r\n");
    ("lines that CR ends", times "#\r");
    ("a long word", times "m");
    ("a long number", fun n -> "imWidth " ^ times "1" n);
    ("a wrong number after a long one", fun n ->
      header ^ "sphere 0 0 " ^ times "0" n ^ " -1 reflective");
    ("a long fraction", fun n -> "depth 0." ^ times "0" n ^ "1");
    ("a long comment", fun n -> "#" ^ times "m" n);
    ("many comments", times "#\n");
    ("NUL", times "\x00");
    ("marks", times "\xef\xbb\xbf");
    ("a comment in a vector", fun n ->
      header ^ "sphere 1e400 #" ^ times "x" n ^ "\n 1e400 1e400 1 reflective");
  ]
[@@ocamlformat "disable"]

let read text =
  ignore
    (Scene_file.parse (Raylab_source.Sources.make ~name:"fuzz" text)
    |> Result.is_ok)

let growth ~measure make n =
  let work n =
    let text = make n in
    (* What the last text left free would be given to a small one for
       nothing. *)
    Gc.compact ();
    let before = measure () in
    read text;
    measure () -. before
  in
  let small = work n in
  work (4 * n) /. small

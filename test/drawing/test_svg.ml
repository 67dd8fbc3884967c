open Raylab_drawing
open Test_support

let hostile = "<b a=\"'\">&\x00\x1b[31m\r\n\x7f\u{9b}\xff\xc3\u{FFFE}\xc3\xa9"

let escaped =
  let no = "\u{FFFD}" in
  "&lt;b a=&quot;'&quot;&gt;&amp;" ^ no ^ no ^ "[31m" ^ no ^ "\n" ^ no ^ no
  ^ no ^ no ^ no ^ "\xc3\xa9"

let test_text () =
  Expect.contains "text"
    ~part:(">" ^ escaped ^ "</text>")
    (Svg.mark (Drawing.text (0., 0.) hostile))

let test_title () =
  Expect.contains "title"
    ~part:("<title>" ^ escaped ^ "</title>")
    (Svg.document
       { Sheet.width = 1.; height = 1.; title = hostile; parts = [] })

(* Nothing that could end an element, start one, or control a terminal. *)
let inert =
  Property.holds "any text is inert" ~print:String.escaped QCheck2.Gen.string
    (fun text ->
      let element words = Svg.mark (Drawing.text (0., 0.) words) in
      let start = element "" and whole = element text in
      let stop = "</text>" in
      let first = String.length start - String.length stop in
      let inside =
        String.sub whole first
          (String.length whole - first - String.length stop)
      in
      String.is_valid_utf_8 inside
      && String.for_all
           (fun c ->
             (c >= ' ' || c = '\n' || c = '\t')
             && not (String.contains "<>\"\x7f" c))
           inside)

let test_number () =
  let pen = Drawing.stroke ~width:1. 0 in
  let line x = Svg.mark (Line (pen, (x, 0.), (0., 0.))) in
  Expect.contains "NaN" ~part:{|x1="0"|} (line nan);
  Alcotest.(check string) "infinity" (line 1e5) (line infinity);
  Alcotest.(check string) "far" (line (-1e5)) (line (-1e300))

let suite =
  ( "Svg",
    [
      Alcotest.test_case "text" `Quick test_text;
      Alcotest.test_case "title" `Quick test_title;
      Alcotest.test_case "number" `Quick test_number;
      inert;
    ] )

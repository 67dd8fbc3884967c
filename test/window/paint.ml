(* A window, 100 x 100, with a drawing that has one of each mark, until a key is
   pressed. *)

open Raylab_scene
open Raylab_drawing
open Raylab_window

let outline = Drawing.stroke ~width:3. 0x0000ff
let green = Drawing.Ink 0x00ff00
let look = Drawing.filled ~outline green

let marks : Drawing.t =
  [
    Box (Drawing.filled (Ink 0xffffff), Rectangle.around (50., 50.) 50.);
    Box (look, { left = 5.; top = 5.; right = 25.; bottom = 25. });
    Circle (look, (50., 15.), 10.);
    Polygon (look, [ (70., 25.); (80., 5.); (95., 25.) ]);
    Box
      ( Drawing.filled ~opacity:0.5 ~outline green,
        Rectangle.around (15., 45.) 10. );
    Line
      ( Drawing.stroke ~dashes:(20., 10.) ~width:3. 0xff0000,
        (40., 45.),
        (90., 45.) );
    Circle (Drawing.filled (Seen (Color.make 1. 0.5 0.)), (15., 75.), 8.);
    Drawing.text ~level:Top ~ink:0 (40., 60.) "MMM";
    Drawing.text ~anchor:End ~ink:0 (90., 90.) "M\u{e9}M";
  ]

let () =
  match Canvas.open_ ~on_loss:ignore ~title:"paint" ~width:100 ~height:100 with
  | Error message -> prerr_endline message
  | Ok canvas ->
      Painter.drawing canvas marks;
      Canvas.show canvas;
      let rec wait () =
        match Canvas.next canvas ~seconds:0.1 with
        | Some (Key _) -> ()
        | Some (Down _ | Up _) | None -> wait ()
      in
      wait ();
      Canvas.close canvas

open Raylab_viewer

let pp_box ppf { Box.left; top; width; height } =
  Format.fprintf ppf "%dx%d+%d+%d" width height left top

let box = Alcotest.testable pp_box ( = )
let pixel = Alcotest.(option (pair int int))
let at left top width height = { Box.left; top; width; height }

let test_fit () =
  let check name expected window picture =
    let layout = Layout.make ~window ~picture in
    Alcotest.check box name expected (Layout.shown layout)
  in
  check "same size" (at 0 0 640 480) (640, 480) (640, 480);
  check "in the middle" (at 30 10 640 480) (700, 500) (640, 480);
  check "whole factors" (at 10 4 30 30) (50, 39) (10, 10);
  check "scaled down" (at 0 60 320 180) (320, 300) (1920, 1080);
  check "never nothing" (at 0 4 10 1) (10, 10) (5000, 1)

let test_window_size () =
  let check name expected screen picture =
    Alcotest.(check (pair int int))
      name expected
      (Layout.window_size ~screen picture)
  in
  check "as large as the picture" (640, 480) (Some (1280, 1024)) (640, 480);
  check "as the screen" (1280, 1024) (Some (1280, 1024)) (1280, 1024);
  check "too wide" (1152, 576) (Some (1280, 1024)) (2000, 1000);
  check "too high" (115, 921) (Some (1280, 1024)) (200, 1600);
  check "unknown screen" (2000, 1000) None (2000, 1000)

let test_pixel () =
  let check name expected window picture place =
    let layout = Layout.make ~window ~picture in
    Alcotest.check pixel name expected (Layout.pixel layout place)
  in
  check "itself" (Some (13, 27)) (40, 30) (40, 30) (13, 27);
  check "beside" None (60, 30) (40, 30) (9, 3);
  check "first" (Some (0, 3)) (60, 30) (40, 30) (10, 3);
  check "magnified" (Some (3, 1)) (30, 30) (10, 10) (11, 5);
  check "scaled: one in the middle" (Some (7, 7)) (4, 4) (12, 12) (2, 2)

let sizes = QCheck.(pair (int_range 1 300) (int_range 1 300))

let prop_pixel_inside =
  QCheck.Test.make ~count:500 ~name:"every place shown names a pixel"
    QCheck.(pair sizes sizes)
    (fun (window, ((w, h) as picture)) ->
      let layout = Layout.make ~window ~picture in
      let { Box.left; top; width; height } = Layout.shown layout in
      List.for_all
        (fun place ->
          match Layout.pixel layout place with
          | Some (x, y) -> 0 <= x && x < w && 0 <= y && y < h
          | None -> false)
        [ (left, top); (left + width - 1, top + height - 1) ])

let prop_columns =
  QCheck.Test.make ~count:500
    ~name:"columns cover the picture, and hold the pixel that is named"
    QCheck.(pair sizes sizes)
    (fun (window, ((w, _) as picture)) ->
      let layout = Layout.make ~window ~picture in
      let { Box.left; top; width; _ } = Layout.shown layout in
      fst (Layout.columns layout 0) = 0
      && snd (Layout.columns layout (width - 1)) = w - 1
      && List.for_all
           (fun u ->
             let first, last = Layout.columns layout u in
             match Layout.pixel layout (left + u, top) with
             | Some (x, _) -> first <= x && x <= last
             | None -> false)
           (List.init width Fun.id))

let prop_box =
  QCheck.Test.make ~count:500
    ~name:"the box of a pixel holds where it is named"
    QCheck.(pair sizes sizes)
    (fun (window, picture) ->
      let layout = Layout.make ~window ~picture in
      let { Box.left; top; width; height } = Layout.shown layout in
      let place = (left + (width / 2), top + (height / 2)) in
      match Layout.pixel layout place with
      | Some (x, y) -> Box.contains (Layout.box layout (at x y 1 1)) place
      | None -> false)

let suite =
  ( "Layout",
    [
      Alcotest.test_case "fit" `Quick test_fit;
      Alcotest.test_case "size of the window" `Quick test_window_size;
      Alcotest.test_case "pixel at a place" `Quick test_pixel;
    ]
    @ List.map QCheck_alcotest.to_alcotest
        [ prop_pixel_inside; prop_columns; prop_box ] )

open Raylab_window

let colors ~window ~picture color box =
  Raster.colors (Layout.make ~window ~picture) color ~background:7 box

let matrix = Alcotest.(array (array int))
let number ~x ~y = (10 * y) + x

let test_itself () =
  Alcotest.check matrix "pixel by pixel"
    [| [| 11; 12 |]; [| 21; 22 |] |]
    (colors ~window:(5, 5) ~picture:(5, 5) number
       { left = 1; top = 1; width = 2; height = 2 })

let test_beside () =
  Alcotest.check matrix "background"
    [| [| 7; 7; 7 |]; [| 0; 0; 0 |]; [| 7; 7; 7 |] |]
    (colors ~window:(3, 3) ~picture:(3, 1)
       (fun ~x:_ ~y:_ -> 0)
       { left = 0; top = 0; width = 3; height = 3 })

let test_magnified () =
  Alcotest.check matrix "squares"
    [| [| 0; 0; 1; 1 |]; [| 0; 0; 1; 1 |] |]
    (colors ~window:(4, 2) ~picture:(2, 1) number
       { left = 0; top = 0; width = 4; height = 2 })

let test_mean () =
  let color ~x ~y:_ = if x land 1 = 0 then 0xff0000 else 0x0000ff in
  Alcotest.check matrix "of all four" [| [| 0x800080 |] |]
    (colors ~window:(2, 2) ~picture:(4, 4) color
       { left = 0; top = 0; width = 1; height = 1 });
  let color ~x ~y:_ = if x < 500 then 0 else 0xffffff in
  Alcotest.check matrix "of some of many" [| [| 0x808080 |] |]
    (colors ~window:(1, 1) ~picture:(1000, 1000) color
       { left = 0; top = 0; width = 1; height = 1 })

let test_dim () =
  Alcotest.(check int) "three tenths" 0x4c0f00 (Raster.dim 0xff3200)

let suite =
  ( "Raster",
    [
      Alcotest.test_case "itself" `Quick test_itself;
      Alcotest.test_case "beside the picture" `Quick test_beside;
      Alcotest.test_case "magnified" `Quick test_magnified;
      Alcotest.test_case "mean" `Quick test_mean;
      Alcotest.test_case "dim" `Quick test_dim;
    ] )

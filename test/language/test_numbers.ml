(* Every rule about the numbers of lights and objects; the errors are marked
   below the lines. *)

let check what block =
  Read.check_errors what
    ("\nimWidth 4 imHeight 3 canvWidth 8 canvHeight 6 depth 5" ^ block)

let test_lights () =
  check "intensity"
    {|
lights spherical -1 red 0 0 0
                 ^^ the intensity must not be negative, not -1
|};
  check "infinite intensity"
    {|
lights spherical 1e999 red 0 0 0
                 ^^^^^ the intensity must be a finite number, not 1e999
|};
  check "colour"
    {|
lights spherical 1 0 -.5 1e400 0 0 0
                     ^^^ the green of the light's colour must not be ...
                         ^^^^^ the blue of the light's colour must be a ...
|};
  check "position"
    {|
lights spherical 1 red 0 -1e999 0
                         ^^^^^^ the y of the light's position must be a ...
|};
  check "direction"
    {|
lights directional 1 red 1e999 0 0
                         ^^^^^ the x of the direction must be a finite ...
|};
  check "zero direction"
    {|
lights directional 1 red 0 -0 0.0
                         ^^^^^^^^ the direction must not be the zero vector
|}

let test_shapes () =
  check "centre"
    {|
sphere 0 0 1e999 1 reflective
           ^^^^^ the z of the centre must be a finite number, not 1e999
|};
  check "radius 0"
    {|
sphere 1 2 6 0 reflective
             ^ the radius must be greater than 0, not 0
|};
  check "negative radius"
    {|
sphere 0 0 6 -2.5 reflective
             ^^^^ the radius must be greater than 0, not -2.5
|};
  check "infinite radius"
    {|
sphere 0 0 6 1e309 reflective
             ^^^^^ the radius must be a finite number, not 1e309
|};
  check "a radius that is 0 as a double"
    {|
sphere 0 0 6 1e-400 reflective
             ^^^^^^ the radius must be greater than 0, not 1e-400
|};
  check "point"
    {|
plane 1e999 0 0 0 1 0 reflective
      ^^^^^ the x of the point must be a finite number, not 1e999
|};
  check "normal"
    {|
plane 0 0 0 0 0 -1e999 reflective
                ^^^^^^ the z of the normal must be a finite number, not -1e999
|};
  check "zero normal"
    {|
plane 1 2 3 0 0 0 reflective
            ^^^^^ the normal must not be the zero vector
|};
  check "a normal that is zero in doubles"
    {|
plane 0 0 0 1e-400 0 0 reflective
            ^^^^^^^^^^ the normal must not be the zero vector
|}

let test_surfaces () =
  check "diffusive"
    {|
sphere 0 0 6 1 diffusive -1 0 0
                         ^^ the red of the surface's colour must not be ...
|};
  check "luminous"
    {|
sphere 0 0 6 1 luminous 0 0 -1
                            ^^ the blue of the surface's colour must not be ...
|};
  check "weight"
    {|
sphere 0 0 6 1 mixed 1 reflective -2 reflective
                                  ^^ the weight must not be negative, not -2
|};
  check "weight that is a colour"
    {|
sphere 0 0 6 1 mixed [1, -2, 1] reflective
                         ^^ the green of the weight must not be negative, ...
|};
  check "index"
    {|
sphere 0 0 6 1 glass 0 white
                     ^ the index of refraction must be greater than 0, not 0
|};
  check "index of refractive"
    {|
sphere 0 0 6 1 refractive -1 white
                          ^^ the index of refraction must be greater than ...
|};
  check "sharpness"
    {|
sphere 0 0 6 1 glossy -1 white
                      ^^ the sharpness of glossy must not be negative, not -1
|};
  check "inside a mix"
    {|
sphere 0 0 6 1 mixed 1 mixed -2 luminous 0 -3 0
                             ^^ the weight must not be negative, not -2
                                           ^^ the green of the surface's ...
|};
  check "over several lines"
    {|
sphere 0 0 6 1 diffusive 1 # red
  # green
  -2 0
  ^^ the green of the surface's colour must not be negative, not -2
|}

(* At the edges of what the rules allow. *)
let test_allowed () =
  List.iter
    (fun text -> ignore (Read.scene (Read.with_header text)))
    [
      "lights spherical 0 0 0 0 0 0 0";
      "lights spherical 1e308 5 6 7 1e308 -1e308 5e-324";
      "lights directional 1 red 5e-324 0 0";
      "sphere 0 0 6 5e-324 mixed 0 reflective";
      "plane 0 0 0 1e308 1e308 1e308 diffusive 100 0 0";
    ]

let suite =
  ( "Numbers",
    [
      Alcotest.test_case "lights" `Quick test_lights;
      Alcotest.test_case "shapes" `Quick test_shapes;
      Alcotest.test_case "surfaces" `Quick test_surfaces;
      Alcotest.test_case "allowed" `Quick test_allowed;
    ] )

open Raylab_language

let check ~acceptable word expected =
  let acceptable token = List.mem token acceptable in
  Alcotest.(check string)
    word expected
    (Suggestion.sentence ~acceptable ~names:[] word)

let settings =
  Parser.
    [ IM_WIDTH; IM_HEIGHT; CANV_WIDTH; CANV_HEIGHT; DEPTH; BCOLOR; RAYDEPTH ]
  @ Parser.[ EYE; LOOK_AT; UP; FOV ]
  @ Parser.[ LIGHTS; OBJECTS; SPHERE; PLANE ]

let lights : Parser.token list =
  [ DIRECTIONAL; SPHERICAL; SPOT; AREA; OBJECTS; SPHERE ]

let surfaces : Parser.token list = [ DIFFUSIVE; REFLECTIVE; LUMINOUS; MIXED ]
let did_you_mean word = Printf.sprintf "Did you mean '%s'?" word

let test_trade () =
  let all ~acceptable expected =
    List.iter (fun word -> check ~acceptable word (did_you_mean expected))
  in
  all ~acceptable:surfaces "reflective" [ "mirror"; "Mirror"; "specular" ];
  all ~acceptable:surfaces "diffusive" [ "matte"; "diffuse"; "lambertian" ];
  all ~acceptable:surfaces "luminous" [ "emission"; "emissive" ];
  all ~acceptable:lights "spherical" [ "point"; "bulb"; "POINT_LIGHT" ];
  all ~acceptable:lights "directional" [ "sun"; "distant-light" ];
  all ~acceptable:lights "spot" [ "spotlight"; "torch" ];
  all ~acceptable:lights "area" [ "area-light"; "SoftBox" ];
  all ~acceptable:settings "bcolor" [ "background"; "sky"; "backgroundColor" ];
  all ~acceptable:settings "depth" [ "distance" ];
  all ~acceptable:settings "eye" [ "camera"; "viewer" ];
  all ~acceptable:settings "lookAt" [ "look_at"; "target" ];
  all ~acceptable:settings "fov" [ "angle"; "field-of-view" ];
  all ~acceptable:settings "raydepth" [ "max_trace_level"; "bounces" ];
  all ~acceptable:settings "sphere" [ "ball" ];
  all ~acceptable:settings "plane" [ "floor"; "ground" ]

let test_several () =
  check ~acceptable:lights "light" "Did you mean 'spherical' or 'directional'?";
  check ~acceptable:settings "lamp" "Did you mean 'lights'?";
  check ~acceptable:settings "resolution"
    "Did you mean 'imWidth' or 'imHeight'?";
  check ~acceptable:lights "mirror" "The language calls that 'reflective'."

let test_nearest () =
  check ~acceptable:surfaces "reflectiv" "Did you mean 'reflective'?";
  check ~acceptable:surfaces "sphare" "";
  check ~acceptable:surfaces "xyz" "";
  check ~acceptable:surfaces "re\u{200b}flectiv" "Did you mean 'reflective'?"

let test_numbers () =
  let check = check ~acceptable:[ NUMBER 0. ] in
  check "1,5" "Did you mean '1.5'?";
  check "-0,25" "Did you mean '-0.25'?";
  check "1,5e3" "Did you mean '1.5e3'?";
  check "0," "Did you mean '0'?";
  check ",5" "Did you mean '5'?";
  check "0,0,6" "Did you mean '0 0 6'?";
  check "\u{2212}1,5" "Did you mean '-1.5'?";
  check "," "";
  check "1,x" "";
  check (String.concat "," (List.init 1000 string_of_int)) ""

(* A word of others that became one of ours would never be looked up. *)
let test_synonyms () =
  let check expected word =
    Alcotest.(check bool) word expected (Keyword.token word <> None)
  in
  List.iter
    (fun (keyword, words) ->
      check true keyword;
      List.iter (check false) words)
    Synonym.all

let suite =
  ( "Suggestion",
    [
      Alcotest.test_case "words of the trade" `Quick test_trade;
      Alcotest.test_case "several" `Quick test_several;
      Alcotest.test_case "nearest" `Quick test_nearest;
      Alcotest.test_case "numbers" `Quick test_numbers;
      Alcotest.test_case "synonyms" `Quick test_synonyms;
    ] )

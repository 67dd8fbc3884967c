type t = {
  scene : string;
  samples : int option;
  x : int;
  y : int;
  why : string;
  summary : string list;
  tree : string list;
}

let ask ?samples scene x y why ~summary ~tree =
  { scene; samples; x; y; why; summary; tree }

let ask_smooth = ask ~samples:16
let ask_plain = ask ~samples:1

let all =
  [
    ask "first" 320 60 "Why is the sky blue?"
      ~summary:[ "pixel (320, 60) is rgb 76 107 178"; "the blue background" ]
      ~tree:[ "hits nothing"; "rgb 0.3 0.42 0.7" ];
    ask "first" 130 220 "Why is the red sphere so bright here?"
      ~summary:[ "a red sphere (object 2, line 30)"; "lit by lights 1 and 2" ]
      ~tree:
        [
          "t = 8.58606";
          "cosine 0.947614";
          "fall-off 0.0503939";
          "rgb 1.0849 0.981637 0.826736";
          "rgb 0.922169 0.196327 0.12401";
        ];
    ask "first" 310 290 "Why is there blue on the middle sphere?"
      ~summary:
        [ "a mirror (sphere 4, line 34) that shows the blue background" ]
      ~tree:[ "hits nothing"; "mirrored rgb 0.3 0.42 0.7" ];
    ask "first" 315 350 "Why has its lower half the colour of the floor?"
      ~summary:
        [
          "a mirror (sphere 4, line 34) that shows the beige plane (object 1, \
           line 26), lit by lights 1 and 2";
        ]
      ~tree:
        [
          "t = 6.02793";
          "t = 0.646339";
          "(0.0478564, -1.5, 1.51018)";
          "mirrored rgb 0.824162 0.637214 0.401675";
        ];
    ask "first" 370 390 "Why is the floor black beside the mirror?"
      ~summary:
        [
          "rgb 0 0 0";
          "a beige plane (object 1, line 26)";
          "in the shadow of sphere 4 (line 34) from lights 1 and 2";
          "no light reaches it";
        ]
      ~tree:[ "blocked by sphere 4 (line 34)"; "t = 0.541932"; "t = 0.37252" ];
    ask "first" 415 110 "Why does the moon look flat?"
      ~summary:[ "a luminous light yellow sphere (object 5, line 36)" ]
      ~tree:[ "luminous 1 0.9 0.6"; "emitted rgb 1 0.9 0.6" ];
    ask "room" 398 115 "Why is there a black disc on the ceiling?"
      ~summary:
        [
          "plane (object 4, line 23)";
          "lit by light 2";
          "in the shadow of sphere 7 (line 29) from light 1";
        ]
      ~tree:[ "t = 1.1373"; "cosine 0.262935"; "fall-off 0.0307267" ];
    ask "room" 315 390 "Why does the ball show a blue wall, which is nowhere?"
      ~summary:
        [
          "a mirror (sphere 8, line 31) that shows the blue plane (object 6, \
           line 25), lit by lights 1 and 2";
        ]
      ~tree:[ "t = 8.16275" ];
    ask "room" 520 370 "Why is there green in the yellow ball?"
      ~summary:
        [
          "a mix of 85 % yellow and 15 % mirror (sphere 9, line 32)";
          "lit by lights 1 and 2";
          "whose mirror shows the dark green plane (object 5, line 24)";
        ]
      ~tree:
        [
          "diffused rgb 0.568428 0.456124 0.169757";
          "mirrored rgb 0.0141186 0.0404821 0.0163869";
          "rgb 0.582546 0.496606 0.186144";
        ];
    ask "over-exposure" 399 240 "Why is orange light white in the middle?"
      ~summary:
        [
          "a white plane (object 1, line 17)"; "over-exposed: red"; "and green";
        ]
      ~tree:[ "fall-off 2.72665"; "rgb 16.2086 5.67302 0.972517" ];
    ask "over-exposure" 399 340 "Why do all three lamps look the same?"
      ~summary:
        [ "a luminous white sphere (object 4, line 26)"; "over-exposed" ]
      ~tree:[ "emitted rgb 3 3 3" ];
    ask "over-exposure" 399 470 "Why is the image of that lamp grey?"
      ~summary:
        [
          "rgb 96 96 96";
          "a 12.5 % mirror (plane 2, line 20) that shows the luminous white \
           sphere (object 4, line 26)";
        ]
      ~tree:[ "rgb 3 3 3"; "mirrored rgb 0.375 0.375 0.375" ];
    ask "coloured-lights" 330 350 "Why is this shadow yellow?"
      ~summary:
        [
          "a white plane (object 1, line 18)";
          "lit by lights 1 and 2";
          "in the shadow of sphere 3 (line 24) from light 3";
        ]
      ~tree:
        [
          "rgb 0.578341 0 0";
          "rgb 0 0.531362 0";
          "rgb 0.578341 0.531362 0";
          "t = 1.6892";
        ];
    ask "coloured-lights" 400 350 "Why is it black under the middle ball?"
      ~summary:
        [
          "in the shadow of sphere 3 (line 24) from lights 1, 2 and 3";
          "no light reaches it";
        ]
      ~tree:[ "diffused rgb 0 0 0" ];
    ask "facing-mirrors" 20 580 "Why is there dark green between the balls?"
      ~summary:
        [
          "rgb 0 34 24";
          "a mix of 93 % mirror and a faint green glow (plane 1, line 24)";
          "the chain of 40 rays has ended";
        ]
      ~tree:[ "emitted rgb 0 0.01 0.007"; "mirrored rgb 0 0.125019 0.0875132" ];
    ask "facing-mirrors" 410 291 "What is that light spot deep in the tunnel?"
      ~summary:[ "the light grey sphere (object 26, line 33" ]
      ~tree:
        [ "rgb 1.01786 0.966965 0.865179"; "rgb 0.658544 0.676047 0.595063" ];
    ask "fall-off" 770 230 "Light 1 reaches this place. Why is it black?"
      ~summary:
        [
          "rgb 0 0 0";
          "lit by light 1";
          "in the shadow of sphere 4 (line 26) from lights 2 and 3";
          "too weakly to be seen";
        ]
      ~tree:[ "cosine 0.0688448"; "fall-off 0.0189584"; "rgb 0.000261037" ];
    ask "fall-off" 265 360 "Why is this side of the ball so white?"
      ~summary:
        [
          "a white sphere (object 3, line 25)";
          "lit by lights 1 and 2";
          "facing away from light 3";
          "over-exposed";
        ]
      ~tree:[ "cosine -0.0912802"; "fall-off 1.47786"; "rgb 1.04439" ];
    ask "inside-a-sphere" 100 350 "Why is the big ball so dark here?"
      ~summary:
        [
          "a mix of 70 % mirror and 30 % beige (sphere 1, line 17)";
          "lit by light 1";
          "in the shadow of sphere 2 (line 19) from light 2";
          "whose mirror shows the blue sphere (object 4, line 21), facing \
           away from lights 1 and 2";
        ]
      ~tree:[ "t = 4.4922"; "cosine -0.0940686"; "mirrored rgb 0 0 0" ];
    ask "sun-and-bulb" 300 180 "Why is there no light of the bulb at the left?"
      ~summary:
        [ "lit by lights 1 and 3"; "in the shadow of plane 2 (line 25)" ]
      ~tree:[ "t = 1.947"; "rgb 0.559173 0.517246 0.432581" ];
    ask "nested-mixes" 190 390 "Is this what the ball above it is made of?"
      ~summary:[ "a mix of 60 % red and 40 % mirror (sphere 3, line 29)" ]
      ~tree:[ "albedo rgb 0.54 0.09 0.06"; "mirror 0.4" ];
    ask "nested-mixes" 190 150 "And that one?"
      ~summary:[ "a mix of 60 % red and 40 % mirror (sphere 2, line 24)" ]
      ~tree:[ "albedo rgb 0.54 0.09 0.06"; "mirror 0.4" ];
    ask "nested-mixes" 620 400 "Why is this ball brighter than the sky?"
      ~summary:
        [
          "a mix of 100 % blue, 50 % mirror and a dark blue glow (sphere 7";
          "shows the light blue background";
          "over-exposed: blue";
        ]
      ~tree:
        [
          "emitted rgb 0.05 0.05 0.15";
          "diffused rgb 0.119895 0.209816 0.539526";
          "mirrored rgb 0.275 0.35 0.45";
        ];
    ask "nested-mixes" 300 545 "There are two lights. Why is it black here?"
      ~summary:
        [
          "in the shadow of sphere 3 (line 29) from light 1";
          "with light 2 behind it";
          "no light reaches it";
        ]
      ~tree:[ "t = 1.21063"; "cosine -0.0995037" ];
    ask "language-tour" 450 440 "Why is this ball black in full light?"
      ~summary:
        [ "a black sphere (object 10, line 31)"; "which returns no light" ]
      ~tree:[ "albedo rgb 0 0 0" ];
    ask "lanterns" 480 300 "What is the purple spot on the mirrored ball?"
      ~summary:
        [
          "a 95 % mirror (sphere 2, line 32) that shows the luminous purple \
           sphere (object 31, line 16";
        ]
      ~tree:[ "t = 0.81295"; "mirrored rgb 0.7125 0.2375 0.95" ];
    ask "billiards" 310 350 "Why is the white ball grey?"
      ~summary:
        [
          "a mix of 88 % white and 12 % mirror (sphere 18, line 61)";
          "lit by lights 1 and 3";
          "facing away from light 2";
          "whose mirror shows the black background";
        ]
      ~tree:[ "cosine 0.095626"; "fall-off 0.0427036"; "cosine -0.117043" ];
    ask "ringed-planet" 560 300 "What is this grain, one of thousands?"
      ~summary:
        [ "a beige sphere (object 4268, line 54"; "lit by lights 1 and 2" ]
      ~tree:[ "t = 11.1907"; "rgb 0.581541 0.464221 0.32803" ];
    ask_smooth "first" 320 239
      "Why is the last row of the sky sky, and no mixture?"
      ~summary:[ "rgb 76 107 178"; "all 4 samples see the blue background" ]
      ~tree:
        [ "4 samples, of at most 16, since the centre is rgb 0.3 0.42 0.7" ];
    ask_smooth "first" 390 120
      "Why is the edge of the moon darker than the moon?"
      ~summary:
        [
          "of 16 samples see the luminous light yellow sphere (object 5, line \
           36); ";
          "see the blue background";
        ]
      ~tree:
        [
          "that see the luminous";
          "emitted rgb 1 0.9 0.6";
          "sum of all 16 samples";
        ];
    ask_smooth "first" 413 79 "Why is the top of the moon paler?"
      ~summary:
        [
          "of 16 samples see the luminous light yellow sphere (object 5, line \
           36); ";
          "the blue background";
        ]
      ~tree:[ "sum of all 16 samples" ];
    ask_smooth "first" 135 200
      "Why is there purple between the red ball and the sky?"
      ~summary:
        [
          "of 16 samples see the blue background; ";
          "see the red sphere (object 2, line 30)";
        ]
      ~tree:[ "that see the red sphere"; "divided by their number" ];
    ask_smooth "first" 346 260 "Why is the edge of the mirror so soft?"
      ~summary:
        [
          "of 16 samples";
          "the mirror (sphere 4, line 34) that shows";
          "see the beige plane (object 1, line 26), lit by lights 1 and 2";
        ]
      ~tree:[ "that see the mirror" ];
    ask_smooth "first" 414 350 "Why does the black shadow not begin at once?"
      ~summary:
        [
          "of 16 samples see the beige plane (object 1, line 26), lit by \
           light 2, in the shadow of sphere 3 (line 32) from light 1; ";
          "see the beige plane (object 1, line 26), in the shadow of sphere 3 \
           (line 32) from lights 1 and 2";
        ]
      ~tree:[ "blocked by sphere 3 (line 32)" ];
    ask_smooth "first" 432 350
      "What is dark under the blue ball, ball or shadow?"
      ~summary:
        [
          "rgb 0 0 0: a mix of 75 % blue and 25 % mirror (sphere 3, line 32)";
          "the beige plane (object 1, line 26), in the shadow of sphere 3 \
           (line 32) from lights 1 and 2";
        ]
      ~tree:[ "faces away" ];
    ask_smooth "first" 597 350 "Why is the pale shadow's edge paler still?"
      ~summary:
        [
          "lit by light 1, in the shadow of sphere 3 (line 32) from light 2";
          "lit by lights 1 and 2";
        ]
      ~tree:[ "blocked by sphere 3 (line 32)"; "sum of all" ];
    ask "over-exposure" 360 342
      "Why is there no white at the edge of the lamp?"
      ~summary:
        [
          "of 16 samples see the white plane (object 1, line 17), lit by \
           light 1; ";
          "the luminous white sphere (object 4, line 26); ";
          "of them over-exposed";
        ]
      ~tree:[ "times the exposure 1, brought into 0 to 1: rgb 1 1 1" ];
    ask "over-exposure" 400 234 "Why is the middle of the orange light white?"
      ~summary:
        [
          "a white plane (object 1, line 17), lit by light 1; over-exposed: \
           red 16.7 and green 5.83, shown as 255";
        ]
      ~tree:[ "brought into 0 to 1: rgb 1 1 0.99" ];
    ask "over-exposure" 559 465 "Why is the edge of the white image grey?"
      ~summary:
        [
          "of 16 samples see the 12.5 % mirror (plane 2, line 20) that shows \
           the luminous white sphere (object 5, line 27)";
          "that shows the white plane (object 1, line 17)";
        ]
      ~tree:[ "mirrored rgb 1 1 1"; "mirrored rgb" ];
    ask "berries" 432 20 "What is the yellow disc?"
      ~summary:[ "a luminous yellow sphere (object" ]
      ~tree:[ "emitted" ];
    ask "berries" 130 246 "Why is the near berry blurred?"
      ~summary:
        [ "of 64 samples see"; "mix of 80 % red and 15 % mirror (sphere" ]
      ~tree:[ "sum of all 64 samples" ];
    ask ~samples:1 "whitted" 83 420
      "Why is the lower half of the small ball as blue as the sky?"
      ~summary:
        [
          "an orange glass sphere (object 3, line 23) that shows the blue \
           background";
          "refracted into the glass (39.4 degrees to the normal become 25): \
           95 % goes through, 4.5 % is mirrored";
        ]
      ~tree:[ "refracted out of the glass (25 degrees to the normal" ];
    ask ~samples:1 "whitted" 83 350 "And why is its upper half red?"
      ~summary:
        [
          "that shows the red quad (object 147, line 28, j = -1, i = -3";
          "(33.7 degrees to the normal become 21.7)";
        ]
      ~tree:[ "point (-2.23"; "refracted rgb" ];
    ask ~samples:1 "whitted" 200 260
      "Why does the large ball show the floor the right way up?"
      ~summary:
        [
          "a glass sphere (object 1.1, line 17) of difference 1 (line 16) \
           that shows the yellow quad (object 154";
          "(38.5 degrees to the normal become 24.5)";
        ]
      ~tree:
        [
          "refracted out of the glass (26.1 degrees to the normal become 41.3)";
          "refracted into the glass (41.3 degrees to the normal become 26.1)";
          "refracted out of the glass (24.5 degrees to the normal become 38.5)";
        ];
    ask ~samples:1 "whitted" 370 410 "Why is this shadow so weak?"
      ~summary:
        [
          "a yellow quad (object 216";
          "lit by lights 1 and 2, in a weak shadow: light 1 went through \
           difference 1 (line 16), and 83 % of it came out";
        ]
      ~tree:[ "through sphere 1.1 (line 17) of difference 1"; "= rgb" ];
    ask ~samples:1 "whitted" 150 428 "And why is that one orange?"
      ~summary:
        [
          "a red quad (object 169";
          "in an orange shadow: light 1 went through sphere 3 (line 23)";
        ]
      ~tree:[ "through sphere 3 (line 23) * rgb" ];
    ask ~samples:1 "whitted" 330 240
      "Why is the rim of the large ball like a mirror?"
      ~summary:[ "64 % goes through, 36 % is mirrored" ]
      ~tree:
        [
          "totally reflected (44 degrees to the normal, and from 41.8 on all \
           is)";
        ];
    ask ~samples:1 "whitted" 25 385 "How much is mirrored at its left edge?"
      ~summary:
        [
          "(72.9 degrees to the normal become 39.6): 79 % goes through, 21 % \
           is mirrored";
        ]
      ~tree:[ "mirrored rgb" ];
    ask ~samples:1 "wine-glass" 215 362 "Why is the table red here?"
      ~summary:
        [
          "in a red shadow: light 1 went through difference 29";
          "intersection 30";
        ]
      ~tree:[ "through" ];
    (* The centres alone: [window] has 16 samples, of which each sees the light
       elsewhere. *)
    ask_plain "window" 40 130
      "Why does the window glow, if lights are not seen?"
      ~summary:[ "a luminous"; "quad (object 6, line 32)" ]
      ~tree:[ "emitted rgb 0.85 0.93 1" ];
    ask_plain "window" 500 305 "Why is the table so bright under the lamp?"
      ~summary:
        [ "(object 14, line 44)"; "lit by light 2"; "and by ambient light" ]
      ~tree:
        [
          "t = 3.05993";
          "cone 1 (16.6908 degrees from the axis)";
          "ambient light: rgb 0.05 0.047 0.043";
        ];
    ask_plain "window" 440 312 "Why is it less bright here?"
      ~summary:
        [
          "(object 14, line 44)";
          "at the edge of the cone of light 2, 26.1 degrees from its axis";
        ]
      ~tree:[ "cone 0.914488 (26.0797 degrees from the axis)" ];
    ask_plain "window" 240 290 "Why is the other end of the table not warm?"
      ~summary:
        [
          "(object 14, line 44)";
          "of 25 points of light 1";
          "outside of the cone of light 2, 46.3 degrees from its axis";
        ]
      ~tree:[ "outside of the cone, 46.2671 degrees from the axis" ];
    ask_plain "window" 330 15 "Does the lamp light the ceiling?"
      ~summary:
        [
          "plane (object 2, line 26)";
          "and by ambient light";
          "outside of the cone of light 2, 117 degrees from its axis";
        ]
      ~tree:[ "t = 4.86995"; "116.795 degrees from the axis" ];
    ask_plain "window" 420 400 "Why is the shadow under the table so soft?"
      ~summary:
        [
          "plane (object 1, line 25)";
          "of 25 points of light 1, while";
          "box 14 (line 44)";
          "in the shadow of box 14 (line 44) from light 2";
        ]
      ~tree:[ "t = 3.55875"; "together they give"; "divided by 25" ];
    ask_plain "window" 363 267 "What is the pale spot on the apple?"
      ~summary:[ "(sphere 22, line 57)"; "in the highlight of light 1" ]
      ~tree:[ "to the highlight of sharpness 120" ];
  ]

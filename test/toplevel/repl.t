"raylab repl": scripts, standard input, and where the program may be. The prompt
at a terminal is in terminal.t.

  $ cat > three.scene <<EOF
  > imWidth 5   imHeight 5   canvWidth 4   canvHeight 4   depth 4
  > bcolor 0 0 0.5
  > lights directional 1 white 0 0 1   spherical 100 red 0 0 9
  > plane 0 -3 0  0 1 0  reflective
  > plane 0 0 20  0 0 1  luminous 1 0.5 0
  > sphere 0 0 2  1      diffusive white
  > EOF
  $ echo 'imWidth 5 sphere 0 0 2 1 difuse white' > broken.scene

[say PHRASES] asks at a prompt with this scene.

  $ say () { echo "$1" | raylab repl three.scene; }

Values
------

They read as mathematics does, and as the documentation says.

  $ say 'vec 1. 2.5 (-3.)'
  - : Vec3.t = (1, 2.5, -3)
  $ say 'primary 2 2'
  - : Ray.t = (0, 0, -4) + t (0, 0, 1)
  $ say 'rgb 1. 0.5 0.'
  - : Color.t = rgb 1 0.5 0
  $ say 'Option.get (hit (primary 2 2))'
  - : Hit.t = object 3, t = 5 at (0, 0, 1), normal (0, 0, -1)
  $ say 'steps (primary 2 2);; next ();; next ()'
  - : Event.t Seq.t = 7 steps
  - : Event.t = cast: (0, 0, -4) + t (0, 0, 1), 4 left in the chain
  - : Event.t = nearest hit: object 3, t = 5 at (0, 0, 1), normal (0, 0, -1)

So do all others.

  $ say 'Ray.direction (primary 2 2)'
  - : Direction.t = (0, 0, 1)
  $ say 'Shape.sphere ~centre:(vec 0. 0. 6.) ~radius:1.'
  - : Shape.t = sphere centre (0, 0, 6) radius 1
  $ say 'Shape.box (Shape.sphere ~centre:(vec 0. 0. 6.) ~radius:1.)'
  - : Box3.t option = Some (-1, -1, 5) to (1, 1, 7)
  $ say 'match (List.hd (scene ()).objects).shape with Plane p -> Some p | _ -> None'
  - : Plane.t option = Some plane point (0, -3, 0) normal (0, 1, 0)
  $ say 'mixed [ (0.5, diffusive red); (0.5, reflective) ]'
  - : Surface.t = mixed 0.5 diffusive 1 0 0 0.5 reflective
  $ say 'Surface.lobes (luminous red)'
  - : Lobes.t = emission rgb 1 0 0, albedo rgb 0 0 0, mirror 0
  $ say 'List.hd (scene ()).lights'
  - : Light.t = directional light, intensity 1, rgb 1 1 1, direction (0, 0, 1)
  $ say 'List.hd (scene ()).objects'
  - : Object.t = plane point (0, -3, 0) normal (0, 1, 0), reflective
  $ say '(scene ()).camera'
  - : Camera.t = 5 x 5 pixels through a canvas of 4 x 4 from (0, 0, -4)
  $ say 'scene ()'
  - : Scene.t =
  scene of 5 x 5 pixels, canvas 4 x 4, depth 4
  background rgb 0 0 0.5, ray depth 4
  light 1: directional light, intensity 1, rgb 1 1 1, direction (0, 0, 1)
  light 2: spherical light, intensity 100, rgb 1 0 0, position (0, 0, 9)
  object 1: plane point (0, -3, 0) normal (0, 1, 0), reflective
  object 2: plane point (0, 0, 20) normal (0, 0, 1), luminous 1 0.5 0
  object 3: sphere centre (0, 0, 2) radius 1, diffusive 1 1 1
  $ say '(Explain.centre (pixel 2 2)).outcome'
  - : Explain.outcome =
  object 3, t = 5 at (0, 0, 1), normal (0, 0, -1)
  sphere centre (0, 0, 2) radius 1, diffusive 1 1 1
  emission rgb 0 0 0, albedo rgb 1 1 1, mirror 0
  light 1: lit, cosine 1, fall-off 1, gives rgb 1 1 1
  light 2: faces away, cosine -1
  $ say 'match (Explain.centre (pixel 2 2)).outcome with Hit h -> h.lights | _ -> []'
  - : Explain.light list =
  [light 1: lit, cosine 1, fall-off 1, gives rgb 1 1 1;
   light 2: faces away, cosine -1]
  $ say 'render ()'
  - : Picture.t = picture of 5 x 5 pixels
  $ say 'snd (Render.picture (Prepared.make (scene ())))'
  - : Tally.t =
  25 primary, 10 reflected and 1 shadow rays, 35 hits, 0 lights blocked
  $ say 'match Scene_file.load "broken.scene" with Error (e :: _) -> Some e | _ -> None'
  - : Scene_error.t option =
  Some
   broken.scene:1:26-31: error: unknown surface 'difuse'
       1 | imWidth 5 sphere 0 0 2 1 difuse white
         |                          ^^^^^^
   expected a surface: diffusive, reflective, luminous, glossy, refractive,
   glass, mixed, checker or varying. Did you mean 'diffusive'?

A pixel is explained as "raylab explain" does it, by the rendering itself.

  $ say 'why 2 2'
  pixel (2, 2) is rgb 255 255 255: a white sphere (object 3, line 6), lit by
  light 1, facing away from light 2
  - : unit = ()
  $ say 'pixel 2 2'
  - : Explain.pixel =
  pixel (2, 2) is rgb 255 255 255: a white sphere (object 3, line 6), lit by
  light 1, facing away from light 2
  
  ray 1: (0, 0, -4) + t (0, 0, 1), 4 left in the chain
    hits sphere 3 (line 6) at t = 5, point (0, 0, 1), normal (0, 0, -1)
    surface: diffusive 1 1 1
    that is, emission rgb 0 0 0, albedo rgb 1 1 1, mirror 0
    light 1 (directional, line 3): lit, cosine 1 * fall-off 1 * intensity 1
        * rgb 1 1 1 = rgb 1 1 1
    light 2 (spherical, line 3): the surface faces away, cosine -1
    all light: rgb 1 1 1
      emitted  rgb 0 0 0
    + diffused rgb 1 1 1 = albedo * all light
    + mirrored rgb 0 0 0
    = colour of ray 1: rgb 1 1 1
  $ say 'explain (primary 2 2) = Explain.centre (pixel 2 2), trace (primary 2 2) = (pixel 2 2).color'
  - : bool * bool = (true, true)

Words
-----

"help ()" has each word of Explore.

  $ say 'help ()' | grep -v '^-' > help
  $ cat help
  help ()       this list
  scene ()      the scene
  load "FILE"   takes another scene, from a file (~time:1. at time 1)
  use SCENE     takes another scene, made of OCaml values
  why X Y       why pixel (X, Y), counted from the top left, has its colour
  pixel X Y     why, in full
  primary X Y   the ray that looks through pixel (X, Y)
  sample X Y K  the ray of its sample K, counted from 1
  trace RAY     the colour that a ray brings
  hit RAY       what a ray hits first
  explain RAY   why it brings that colour
  steps RAY     what the tracer does for it, step by step: say next ()
  next ()       the next step
  back ()       the step before
  render ()     the picture of the scene
  show ()       the picture in a window, where a click explains a pixel
  save "FILE"   writes it as .bmp, .png or .ppm
  
  Scenes are built with vec, rgb, hsv, red ... white, directional, spherical,
  spot, area, sphere, plane, box, cylinder, cone, torus, disc, triangle, quad,
  mesh, diffusive, reflective, luminous, glossy, refractive, glass, mixed, tinted
  and checker, as in a scene file, and varying "p ..."; put together by union,
  intersection and difference; unfading is for lights; random, noise and
  turbulence are numbers:
  
  use (Scene.make camera
         ~lights:[ directional 1. white (vec 1. (-1.) 1.) ]
         ~objects:[ sphere (vec 0. 0. 6.) 1. (diffusive red) ])
  
  Scene.with_ray_depth 6 (scene ()) is the scene with one thing changed. Others
  are with_background, with_ambient, with_lights, with_objects, with_camera,
  with_lens and with_film: Scene.with_film (Film.make ~samples:16 ()) (scene ())
  is smooth.
  looking (vec 3. 2. (-4.)) (vec 0. 0. 0.) camera is a camera elsewhere.
  $ sed -n 's/^val \([a-z]*\) .*/\1/p' ../../lib/toplevel/explore.mli | sort > words
  $ sed '/^$/,$d; s/ .*//' help | sort | diff - words
  $ awk 'length > 79' help

The scene that it builds is one.

  $ say "$(sed -n '/^use (/,/^$/p' help);; why 320 240"
  - : unit = ()
  pixel (320, 240) is rgb 145 0 0: a red sphere (object 1), lit by light 1
  - : unit = ()

A scene with one thing changed keeps all else.

  $ say 'use (Scene.with_ray_depth 6 (scene ()));; scene ()' > changed
  $ say 'scene ()' | diff - changed
  0a1
  > - : unit = ()
  3c4
  < background rgb 0 0 0.5, ray depth 4
  ---
  > background rgb 0 0 0.5, ray depth 6
  [1]

Steps go on and back.

  $ say 'next ()'
  Exception:
  Invalid_argument "there are no steps yet: say steps (primary X Y) first".
  $ say 'steps (primary 0 0);; next ();; back ()'
  - : Event.t Seq.t = 4 steps
  - : Event.t =
  cast: (0, 0, -4) + t (-0.348155, 0.348155, 0.870388), 4 left in the chain
  Exception: Invalid_argument "there is no step before; next () goes on".
  $ say 'steps (primary 0 0);; next ();; next ();; back ();; next ();; next ();; next ();; next ()'
  - : Event.t Seq.t = 4 steps
  - : Event.t =
  cast: (0, 0, -4) + t (-0.348155, 0.348155, 0.870388), 4 left in the chain
  - : Event.t =
  nearest hit: object 2, t = 27.5739 at (-9.6, 9.6, 20), normal (0, 0, -1)
  - : Event.t =
  cast: (0, 0, -4) + t (-0.348155, 0.348155, 0.870388), 4 left in the chain
  - : Event.t =
  nearest hit: object 2, t = 27.5739 at (-9.6, 9.6, 20), normal (0, 0, -1)
  - : Event.t =
  mix: emitted rgb 1 0.5 0 + diffused rgb 0 0 0 + mirrored rgb 0 0 0
    = rgb 1 0.5 0
  - : Event.t = done: rgb 1 0.5 0
  Exception: Invalid_argument "that was the last step; back () goes back".
  $ say 'steps (primary 0 0);; use empty;; next ()'
  - : Event.t Seq.t = 4 steps
  warning: there is no object: the picture is all background
  - : unit = ()
  Exception:
  Invalid_argument "there are no steps yet: say steps (primary X Y) first".

A pixel that is not there:

  $ say 'why 5 0'
  Exception:
  Invalid_argument "there is no pixel (5, 0): x goes from 0 to 4, y from 0 to 4".
  $ say 'pixel 0 (-1)'
  Exception:
  Invalid_argument "there is no pixel (0, -1): x goes from 0 to 4, y from 0 to 4".

"load" takes another scene, with its warnings, or tells what is wrong and leaves
the scene as it was.

  $ sed 's/depth 4/depth 2/; /lights/d' three.scene > four.scene
  $ say 'load "four.scene";; (scene ()).camera' 2>&1
  four.scene: 3 objects, 0 lights, 5 x 5 pixels
  four.scene: warning: there is no light: diffusive surfaces are black
  - : unit = ()
  - : Camera.t = 5 x 5 pixels through a canvas of 4 x 4 from (0, 0, -2)
  $ say 'load "broken.scene";; (scene ()).camera' 2>&1
  broken.scene:1:26-31: error: unknown surface 'difuse'
      1 | imWidth 5 sphere 0 0 2 1 difuse white
        |                          ^^^^^^
  expected a surface: diffusive, reflective, luminous, glossy, refractive,
  glass, mixed, checker or varying. Did you mean 'diffusive'?
  - : unit = ()
  - : Camera.t = 5 x 5 pixels through a canvas of 4 x 4 from (0, 0, -4)
  $ say 'load "missing.scene";; (scene ()).camera' 2>&1
  missing.scene: error: No such file or directory
  - : unit = ()
  - : Camera.t = 5 x 5 pixels through a canvas of 4 x 4 from (0, 0, -4)

"use" warns as well, of a scene that no file has.

  $ say 'use (Scene.make camera)' 2>&1
  warning: there is no object: the picture is all background
  - : unit = ()

A scene made of values is the one that a file says, and can be seen.

  $ cat > built.ml <<EOF
  > let from_file = scene ()
  > let camera =
  >   Camera.make ~width:5 ~height:5 ~canvas_width:4. ~canvas_height:4. ~depth:4.
  > let () =
  >   use
  >     (Scene.make camera ~background:(rgb 0. 0. 0.5)
  >        ~lights:
  >          [ directional 1. white (vec 0. 0. 1.);
  >            spherical 100. red (vec 0. 0. 9.) ]
  >        ~objects:
  >          [ plane (vec 0. (-3.) 0.) (vec 0. 1. 0.) reflective;
  >            plane (vec 0. 0. 20.) (vec 0. 0. 1.) (luminous (rgb 1. 0.5 0.));
  >            sphere (vec 0. 0. 2.) 1. (diffusive white) ]);
  >   assert (Scene.equal (scene ()) from_file);
  >   save "built.bmp"
  > EOF
  $ raylab repl three.scene built.ml
  wrote built.bmp

Pictures
--------

"save" writes what "raylab render" writes, in each format, whether the native
program rendered it or the prompt itself.

  $ for format in bmp png ppm; do raylab render three.scene -q -o r.$format; done
  $ cmp built.bmp r.bmp
  $ say 'save "s.bmp";; save "s.png";; save "s.ppm"'
  wrote s.bmp
  - : unit = ()
  wrote s.png
  - : unit = ()
  wrote s.ppm
  - : unit = ()
  $ for format in bmp png ppm; do cmp s.$format r.$format; done
  $ raylab render three.scene -q --size 7x3 -o r.bmp
  $ say 'let s = scene ();;
  > use (Scene.with_camera (Camera.with_size ~width:7 ~height:3 s.camera) s);;
  > Picture.equal (render ()) (fst (Render.picture (Prepared.make (scene ()))));;
  > save "s.bmp";;
  > Unix.putenv "RAYLAB_PROGRAM" "/missing";;
  > save "t.bmp";;'
  val s : Scene.t =
    scene of 5 x 5 pixels, canvas 4 x 4, depth 4
    background rgb 0 0 0.5, ray depth 4
    light 1: directional light, intensity 1, rgb 1 1 1, direction (0, 0, 1)
    light 2: spherical light, intensity 100, rgb 1 0 0, position (0, 0, 9)
    object 1: plane point (0, -3, 0) normal (0, 1, 0), reflective
    object 2: plane point (0, 0, 20) normal (0, 0, 1), luminous 1 0.5 0
    object 3: sphere centre (0, 0, 2) radius 1, diffusive 1 1 1
  warning: canvas and picture differ in proportions: the picture looks 2.33 times as wide as it should
  - : unit = ()
  - : bool = true
  wrote s.bmp
  - : unit = ()
  - : unit = ()
  wrote t.bmp
  - : unit = ()
  $ cmp s.bmp r.bmp && cmp t.bmp r.bmp

A mesh is in its file, wherever the picture is made.

  $ mkdir -p meshes && printf 'v -1 -1 0\nv 0 1 0\nv 1 -1 0\nf 1 2 3\n' > meshes/a.obj
  $ say 'mesh "meshes/a.obj" (diffusive red)'
  - : Object.t = mesh "meshes/a.obj", diffusive 1 0 0
  $ say 'mesh "three.scene" reflective'
  Exception: Failure "three.scene is no name of a mesh: .obj, .ply or .stl".
  $ (cat three.scene; echo 'mesh "meshes/a.obj" smooth diffusive red') > mesh.scene
  $ raylab render -q mesh.scene -o mesh.bmp
  $ echo 'save "again.bmp"' | raylab repl mesh.scene
  wrote again.bmp
  - : unit = ()
  $ cmp mesh.bmp again.bmp
  $ cat > more.ml <<EOF
  > let again = translated (vec 1. 0. 0.) (mesh ~smooth:true "meshes/a.obj" reflective)
  > let () =
  >   let s = scene () in
  >   use (Scene.with_objects (s.objects @ [ again ]) s);
  >   save "more.bmp"
  > EOF
  $ raylab repl mesh.scene more.ml
  wrote more.bmp
  $ echo 'mesh "meshes/a.obj" smooth reflective translated 1 0 0' >> mesh.scene
  $ raylab render -q mesh.scene -o mesh.bmp
  $ cmp mesh.bmp more.bmp

Names are told as they can be printed:

  $ say 'save "a\027[31mb\xc2\x9bc\xff.ppm"' | LC_ALL=C sed 's/\xef\xbf\xbd/?/g'
  wrote a?[31mb?c?.ppm
  - : unit = ()
  $ rm a*.ppm

What cannot be written, or not rendered:

  $ say 'save "s.gif"'
  Exception:
  Invalid_argument
   "s.gif: there is no picture format '.gif'; use .bmp, .png or .ppm".
  $ say 'save "missing/s.bmp"'
  Exception: Sys_error "missing/s.bmp: No such file or directory".
  $ say 'use (Scene.make (Camera.with_size ~width:2000000000 ~height:9 camera));; render ()'
  warning: there is no object: the picture is all background
  warning: canvas and picture differ in proportions: the picture looks 1.67e+08 times as wide as it should
  - : unit = ()
  Exception:
  Sys_error
   "a picture of 2000000000 x 9 pixels would take 50.3 GiB of memory; the limit is 4 GiB".
  $ mkdir tmp
  $ TMPDIR=$PWD/tmp say 'ignore (render ())'
  - : unit = ()
  $ ls tmp
  $ (trap '' XFSZ; ulimit -f 0; TMPDIR=tmp say 'render ()') |
  >   sed 's/raylab[0-9a-f]\{6\}/raylabN/'
  Exception: Sys_error "tmp/raylabN/scene: File too large".
  $ ls tmp

Scripts
-------

A script prints only what it says; its end is the program's.

  $ script () { echo "$1" > script.ml; raylab repl three.scene script.ml; }
  $ script 'let () = print_endline "hello"  let x = 1'
  hello
  $ script 'print_endline "one";; exit 3;; print_endline "two"'
  one
  [3]
  $ script 'print_endline "one";; assert (trace (primary 2 2) = black)'
  one
  Exception: Assert_failure ("script.ml", 1, 22).
  [2]
  $ script 'raise Not_found'
  Exception: Not_found.
  [2]
  $ script '1 + "one"'
  File "script.ml", line 1, characters 4-9:
  1 | 1 + "one"
          ^^^^^
  Error: This constant has type "string" but an expression was expected of type
           "int"
  [2]

Editors may begin one with a byte-order mark, or a file for #use, or what is piped
in; it makes no difference to the places of errors. Another encoding is named.

  $ printf '\357\273\277print_endline "hello";; 1 + "one"' > marked.ml
  $ raylab repl three.scene marked.ml
  hello
  File "marked.ml", line 1, characters 28-33:
  1 | print_endline "hello";; 1 + "one"
                                  ^^^^^
  Error: This constant has type "string" but an expression was expected of type
           "int"
  [2]
  $ echo '#use "marked.ml"' | raylab repl three.scene 2>&1
  hello
  - : unit = ()
  File "marked.ml", line 1, characters 28-33:
  1 | print_endline "hello";; 1 + "one"
                                  ^^^^^
  Error: This constant has type "string" but an expression was expected of type "int"
  $ printf '\357\273\2771 + 1;;' | raylab repl three.scene
  - : int = 2
  $ printf '\377\3761\000' > utf16.ml
  $ raylab repl three.scene utf16.ml 2>&1 | tail -n 1
  Error: The text is UTF-16. Save it as UTF-8.

  $ script 'print_endline Sys.argv.(0); assert (Array.length Sys.argv = 1)'
  script.ml
  $ script 'print_endline (read_line ())' < help
  help ()       this list
  $ raylab repl three.scene missing.ml
  Cannot find file missing.ml.
  [2]

It needs no scene if its name tells what it is, but never runs with a scene in
error.

  $ echo 'print_int (List.length (scene ()).objects)' > script.ml
  $ raylab repl script.ml
  0
  $ raylab repl broken.scene script.ml
  broken.scene:1:26-31: error: unknown surface 'difuse'
      1 | imWidth 5 sphere 0 0 2 1 difuse white
        |                          ^^^^^^
  expected a surface: diffusive, reflective, luminous, glossy, refractive,
  glass, mixed, checker or varying. Did you mean 'diffusive'?
  [1]
  $ raylab repl - script.ml < three.scene
  3

Without a terminal
------------------

The input's end ends the last phrase. Errors go to the same place as values, and
the next phrase is read.

  $ printf '1 +' | raylab repl
  Line 2, characters 0-2:
  Error: Syntax error
  $ printf 'nothing;;\n1 + 1' | raylab repl
  Line 1, characters 0-7:
  Error: Unbound value "nothing"
  Hint: Did you mean "looking"?
  - : int = 2
  $ echo 'why 2 2' | raylab repl three.scene > /dev/full
  raylab: standard output: No space left on device
  [2]
  $ printf '' | raylab repl
  $ raylab repl < /dev/null

A scene in error is reported, and the scene is empty.

  $ echo 'scene ()' | raylab repl broken.scene
  broken.scene:1:26-31: error: unknown surface 'difuse'
      1 | imWidth 5 sphere 0 0 2 1 difuse white
        |                          ^^^^^^
  expected a surface: diffusive, reflective, luminous, glossy, refractive,
  glass, mixed, checker or varying. Did you mean 'diffusive'?
  - : Scene.t =
  scene of 640 x 480 pixels, canvas 4 x 3, depth 4
  background rgb 0 0 0, ray depth 4
  $ echo 'scene ()' | raylab repl missing.scene
  missing.scene: error: No such file or directory
  - : Scene.t =
  scene of 640 x 480 pixels, canvas 4 x 3, depth 4
  background rgb 0 0 0, ray depth 4

The command line
----------------

  $ raylab repl a b c
  raylab: too many arguments, don't know what to do with 'c'
  Usage: raylab repl [--allow=DIR] [OPTION]… [SCENE] [SCRIPT]
  Try 'raylab repl --help' or 'raylab --help' for more information.
  [124]
  $ raylab repl -
  raylab: a scene from standard input leaves nothing for the prompt to read
  [124]

Anywhere
--------

The two programs run wherever they are together: copied, linked to, from another
directory, without a home.

  $ mkdir -p 'moved to/bin'
  $ cp "$(command -v raylab)" "$(command -v raylab-utop)" 'moved to/bin'
  $ there=$PWD/moved\ to/bin/raylab here=$PWD
  $ cd /
  $ echo 'why 2 2;; List.length (scene ()).objects;; Picture.width (render ())' |
  >   env -i "$there" repl "$here/three.scene"
  pixel (2, 2) is rgb 255 255 255: a white sphere (object 3, line 6), lit by
  light 1, facing away from light 2
  - : unit = ()
  - : int = 3
  - : int = 5
  $ env -i PATH=/nowhere HOME=/nowhere "$there" repl "$here/script.ml"
  0
  $ cd "$here" && ln -s "$there" link
  $ ./link repl script.ml
  0
  $ rm "$there-utop"
  $ "$there" repl
  raylab: cannot run $TESTCASE_ROOT/moved to/bin/raylab-utop, which belongs beside $TESTCASE_ROOT/moved to/bin/raylab: No such file or directory. In a checkout dune build @install makes it
  [125]

"raylab check" reports errors and warnings, and renders nothing. Rendering
reports the errors in the same words.

  $ cat > good.scene <<EOF
  > imWidth 4   imHeight 3   canvWidth 4   canvHeight 3   depth 4
  > sphere 0 0 6 1 luminous red
  > EOF
  $ cat > broken.scene <<EOF
  > imWidth 4   imHeight 3   canvWidth 4   canvHeight 3   depth 4
  > sphere 0 0 6 1 difuse red
  > EOF
  $ cat > unlit.scene <<EOF
  > imWidth 4   imHeight 4   canvWidth 4   canvHeight 3   depth 4
  > sphere 0 0 6 1 diffusive red
  > EOF

There is nothing to say of a good scene.

  $ raylab check good.scene

An error names the place, shows it, and says what to write instead.

  $ raylab check broken.scene 2> err
  [1]
  $ cat err
  broken.scene:2:16-21: error: unknown surface 'difuse'
      2 | sphere 0 0 6 1 difuse red
        |                ^^^^^^
  expected a surface: diffusive, reflective, luminous, glossy, refractive,
  glass, mixed, checker or varying. Did you mean 'diffusive'?

Warnings leave the scene as good as it was.

  $ raylab check unlit.scene
  unlit.scene: warning: there is no light: diffusive surfaces are black
  unlit.scene: warning: canvas and picture differ in proportions: the picture looks 1.33 times as high as it should

What is wrong with lights, colours and planes is told with their lines.

  $ cat > hardly.scene <<'END'
  > imWidth 40 imHeight 30 canvWidth 4 canvHeight 3 depth 4
  > lights
  > spherical 5 255 128 0  0 0 6
  > spherical 5 white      0 3 6
  > objects
  > plane 0 -2 0  0 1 0    diffusive 200 180 140
  > plane 5 -2 0  0 -3 0   reflective
  > sphere 0 0 6  1        luminous white
  > END
  $ raylab check hardly.scene
  hardly.scene: warning: light 1 has the colour 255 128 0, which looks like 0 to 255; from 0 to 1 it is 1 0.502 0 (line 3)
  hardly.scene: warning: plane 1 has the colour 200 180 140, which looks like 0 to 255; from 0 to 1 it is 0.784 0.706 0.549 (line 6)
  hardly.scene: warning: light 1 is inside sphere 3, which keeps its light in (lines 3 and 8)
  hardly.scene: warning: plane 2 is where plane 1 is: they hide each other (lines 6 and 7)
  $ rm hardly.scene

So is a name that takes over a word of the language.

  $ cat > taken.scene << END
  > imWidth 40 imHeight 30 canvWidth 4 canvHeight 3 depth 4
  > let sand = 0.9 0.8 0.6   let white = 0.9 0.9 0.9
  > lights spherical 5 white  0 3 6
  > for red = 0 to 1  sphere red 0 6  0.3  diffusive sand end
  > END
  $ raylab check taken.scene
  taken.scene: warning: 'white' is a name from here to the end of its block, and no longer the word of the language (line 2)
  taken.scene: warning: 'red' is a name from here to the end of its block, and no longer the word of the language (line 4)
  $ rm taken.scene

Several scenes, each of which is read: one in error is enough for exit status 1.

  $ raylab check good.scene broken.scene missing.scene unlit.scene good.scene 2>&1 |
  >   grep scene:
  broken.scene:2:16-21: error: unknown surface 'difuse'
  missing.scene: error: No such file or directory
  unlit.scene: warning: there is no light: diffusive surfaces are black
  unlit.scene: warning: canvas and picture differ in proportions: the picture looks 1.33 times as high as it should
  $ raylab check missing.scene good.scene 2> /dev/null
  [1]
  $ raylab check good.scene - unlit.scene < broken.scene 2>&1 | grep error
  <standard input>:2:16-21: error: unknown surface 'difuse'
  $ raylab check - < good.scene

It wrote no file and nothing to standard output.

  $ raylab check broken.scene good.scene unlit.scene 2> /dev/null
  [1]
  $ ls -A
  broken.scene
  err
  good.scene
  unlit.scene

Rendering
---------

The same errors and exit status, whatever the command. There is no picture, and
an older one stays.

  $ echo older > broken.bmp
  $ raylab broken.scene 2> err2
  [1]
  $ cmp err err2
  $ raylab render broken.scene -q -o new.png 2> err2
  [1]
  $ cmp err err2
  $ raylab render broken.scene -o - 2> err2 | wc -c
  0
  $ cmp err err2
  $ cat broken.bmp
  older
  $ ls -A
  broken.bmp
  broken.scene
  err
  err2
  good.scene
  unlit.scene

Kinds of errors
---------------

[scene TEXT] checks a header and TEXT, and shows the errors without advice.

  $ scene () {
  >   { head -n 1 good.scene; printf "$1"; } > s.scene
  >   raylab check s.scene 2> err; code=$?
  >   awk '/: error: / { n = 3 } n-- > 0' err; return $code
  > }

A word that is not known, a number that is none, an end too early:

  $ scene 'spere 0 0 6 1 reflective'
  s.scene:2:1-5: error: unknown keyword 'spere'
      2 | spere 0 0 6 1 reflective
        | ^^^^^
  [1]
  $ scene 'sphere 0 0 six 1 reflective'
  s.scene:2:12-14: error: 'six' is not a number
      2 | sphere 0 0 six 1 reflective
        |            ^^^
  [1]
  $ scene 'sphere 0 0 6 1'
  s.scene:2:15: error: the file ends where a surface should follow
      2 | sphere 0 0 6 1
        |               ^
  [1]
  $ scene 'sphere 0 0 6 1 reflective blue'
  s.scene:2:27-30: error: a shape should stand here, not 'blue'
      2 | sphere 0 0 6 1 reflective blue
        |                           ^^^^
  [1]

Values that do not make sense are all reported, not only the first.

  $ scene 'lights directional -1 white 0 0 0\nsphere 0 0 1e999 0 diffusive 1 -1 1'
  s.scene:2:20-21: error: the intensity must not be negative, not -1
      2 | lights directional -1 white 0 0 0
        |                    ^^
  s.scene:2:29-33: error: the direction must not be the zero vector
      2 | lights directional -1 white 0 0 0
        |                             ^^^^^
  s.scene:3:12-16: error: the z of the centre must be a finite number, not 1e999
      3 | sphere 0 0 1e999 0 diffusive 1 -1 1
        |            ^^^^^
  s.scene:3:18: error: the radius must be greater than 0, not 0
      3 | sphere 0 0 1e999 0 diffusive 1 -1 1
        |                  ^
  s.scene:3:32-33: error: the green of the surface's colour must not be negative, not -1
      3 | sphere 0 0 1e999 0 diffusive 1 -1 1
        |                                ^^
  [1]
  $ scene 'imWidth 5 raydepth -1 bcolor 0 0 -2 plane 0 0 5 0 0 0 reflective'
  s.scene:2:1-7: error: imWidth is set a second time
      2 | imWidth 5 raydepth -1 bcolor 0 0 -2 plane 0 0 5 0 0 0 reflective
        | ^^^^^^^
  s.scene:2:20-21: error: raydepth must be a whole number from 0 to 1000000, not -1
      2 | imWidth 5 raydepth -1 bcolor 0 0 -2 plane 0 0 5 0 0 0 reflective
        |                    ^^
  s.scene:2:34-35: error: the blue of bcolor must not be negative, not -2
      2 | imWidth 5 raydepth -1 bcolor 0 0 -2 plane 0 0 5 0 0 0 reflective
        |                                  ^^
  s.scene:2:49-53: error: the normal must not be the zero vector
      2 | imWidth 5 raydepth -1 bcolor 0 0 -2 plane 0 0 5 0 0 0 reflective
        |                                                 ^^^^^
  [1]
  $ scene 'raydepth 1.5'
  s.scene:2:10-12: error: raydepth must be a whole number from 0 to 1000000, not 1.5
      2 | raydepth 1.5
        |          ^^^
  [1]

What is missing:

  $ printf '' > empty.scene
  $ raylab check empty.scene 2>&1 | head -n 1
  empty.scene:1:1: error: the header lacks imWidth, imHeight, canvWidth, canvHeight, depth

Bytes that are no text, and a scene that is no file:

  $ head -c 2000 /dev/zero > zero.scene
  $ raylab check zero.scene 2>&1 | head -n 1 | cut -c 1-44
  zero.scene:1:1: error: U+0000, a NUL, is not
  $ mkdir dir.scene
  $ raylab check dir.scene
  dir.scene: error: Is a directory
  [1]
  $ raylab dir.scene
  dir.scene: error: Is a directory
  [1]
  $ raylab render missing.scene
  missing.scene: error: No such file or directory
  [1]
  $ raylab missing/missing.scene
  missing/missing.scene: error: No such file or directory
  [1]
  $ raylab good.scene/good.scene
  good.scene/good.scene: error: Not a directory
  [1]

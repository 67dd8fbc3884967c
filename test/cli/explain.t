Why a pixel has its colour. This scene's picture has three pixels: a mirror that
shows the floor, the sky, and a wall.

  $ unset DISPLAY
  $ cat > three.scene <<EOF
  > imWidth 3   imHeight 1   canvWidth 6   canvHeight 2   depth 4
  > bcolor 0.2 0.4 0.6
  > lights
  > spherical 8 white  -2 3 3
  > directional 2 white  0 1 0
  > objects
  > sphere -4 0.5 4  1    reflective
  > plane 0 -2 0  0 1 0   diffusive 1 0.5 0
  > plane 2.5 0 0  1 0 0  diffusive white
  > EOF

A summary, and then all of it.

  $ raylab explain three.scene 0,0
  pixel (0, 0) is rgb 73 37 0: a mirror (sphere 1, line 7) that shows the
  orange plane (object 2, line 8), lit by light 1, with light 2 behind it
  
  ray 1: (0, 0, -4) + t (-0.447214, 0, 0.894427), 4 left in the chain
    hits sphere 1 (line 7) at t = 8.07825, point (-3.6127, 0, 3.2254),
        normal (0.387298, -0.5, -0.774597)
    surface: reflective
    that is, emission rgb 0 0 0, albedo rgb 0 0 0, mirror 1
    lights do not matter: the albedo is 0
    ray 2, mirrored: (-3.61269, -1e-05, 3.22539)
        + t (0.223607, -0.866025, -0.447214), 3 left in the chain
      hits plane 2 (line 8) at t = 2.30939, point (-3.0963, -2, 2.1926),
          normal (0, 1, 0)
      surface: diffusive 1 0.5 0
      that is, emission rgb 0 0 0, albedo rgb 1 0.5 0, mirror 0
      light 1 (spherical, line 4): lit, cosine 0.964867 * fall-off 0.0372387
          * intensity 8 * rgb 1 1 1 = rgb 0.287443 0.287443 0.287443
      light 2 (directional, line 5): the surface faces away, cosine -1
      all light: rgb 0.287443 0.287443 0.287443
        emitted  rgb 0 0 0
      + diffused rgb 0.287443 0.143722 0 = albedo * all light
      + mirrored rgb 0 0 0
      = colour of ray 2: rgb 0.287443 0.143722 0
      emitted  rgb 0 0 0
    + diffused rgb 0 0 0 = albedo * all light
    + mirrored rgb 0.287443 0.143722 0 = 1 * colour of ray 2
    = colour of ray 1: rgb 0.287443 0.143722 0
  $ raylab explain three.scene 1,0
  pixel (1, 0) is rgb 51 102 153: the blue background, since the ray hits
  nothing
  
  ray 1: (0, 0, -4) + t (0, 0, 1), 4 left in the chain
    hits nothing: the background, rgb 0.2 0.4 0.6

Several pixels, one after another.

  $ raylab explain three.scene 1,0 2,0 | grep -A 2 pixel
  pixel (1, 0) is rgb 51 102 153: the blue background, since the ray hits
  nothing
  
  --
  pixel (2, 0) is rgb 48 48 48: a white plane (object 3, line 9), lit by light
  1, edge-on to light 2
  

From standard input; with a picture of another size, and in grey.

  $ raylab explain - 1,0 < three.scene > in
  $ raylab explain three.scene 1,0 | cmp - in
  $ raylab explain three.scene --size 30x10 15,5 | head -n 2
  pixel (15, 5) is rgb 0 0 0: an orange plane (object 2, line 8), lit by light
  1, but too weakly to be seen, with light 2 behind it
  $ raylab explain three.scene --grey 1,0 | head -n 1
  pixel (1, 0) is rgb 95 95 95: the grey background, since the ray hits nothing

There is nothing in it but text: no control character, and no long line.

  $ raylab explain three.scene 0,0 1,0 2,0 | LC_ALL=C grep -c '[^ -~]'
  0
  [1]
  $ raylab explain three.scene 0,0 1,0 2,0 | grep '.\{81\}'
  [1]

It says of a pixel what the picture shows.

  $ raylab render three.scene -q -o three.ppm
  $ tail -c 9 three.ppm | od -A n -v -t u1 -w3
    73  37   0
    51 102 153
    48  48  48
  $ raylab explain three.scene 0,0 1,0 2,0 | grep -o 'is rgb.*:'
  is rgb 73 37 0:
  is rgb 51 102 153:
  is rgb 48 48 48:

Steps
-----

One a line, numbered, in the order of the tracer's work.

  $ raylab explain three.scene --steps 0,0
     1  cast: (0, 0, -4) + t (-0.447214, 0, 0.894427), 4 left in the chain
     2  nearest hit: object 1, t = 8.07825 at (-3.6127, 0, 3.2254), normal (0.387298, -0.5, -0.774597)
     3  bounce: (-3.61269, -1e-05, 3.22539) + t (0.223607, -0.866025, -0.447214), 3 left in the chain
     4  nearest hit: object 2, t = 2.30939 at (-3.0963, -2, 2.1926), normal (0, 1, 0)
     5  shadow ray to light 1: (-3.0963, -1.99998, 2.1926) + t (0.211557, 0.964867, 0.155808), t < 5.18202
     6  light 1: lit, cosine 0.964867, fall-off 0.0372387, gives rgb 0.287443 0.287443 0.287443
     7  light 2: faces away, cosine -1
     8  mix: emitted rgb 0 0 0 + diffused rgb 0.287443 0.143722 0 + mirrored rgb 0 0 0 = rgb 0.287443 0.143722 0
     9  mix: emitted rgb 0 0 0 + diffused rgb 0 0 0 + mirrored rgb 0.287443 0.143722 0 = rgb 0.287443 0.143722 0
    10  done: rgb 0.287443 0.143722 0
  $ raylab explain three.scene --steps 1,0 2,0
  pixel (1, 0)
     1  cast: (0, 0, -4) + t (0, 0, 1), 4 left in the chain
     2  nothing hit: the background, rgb 0.2 0.4 0.6
     3  done: rgb 0.2 0.4 0.6
  
  pixel (2, 0)
     1  cast: (0, 0, -4) + t (0.447214, 0, 0.894427), 4 left in the chain
     2  nearest hit: object 3, t = 5.59017 at (2.5, 0, 1), normal (-1, 0, 0)
     3  shadow ray to light 1: (2.49998, 0, 1) + t (-0.780398, 0.520267, 0.346845), t < 5.76625
     4  light 1: lit, cosine 0.780399, fall-off 0.0300752, gives rgb 0.187765 0.187765 0.187765
     5  light 2: faces away, cosine 0
     6  mix: emitted rgb 0 0 0 + diffused rgb 0.187765 0.187765 0.187765 + mirrored rgb 0 0 0 = rgb 0.187765 0.187765 0.187765
     7  done: rgb 0.187765 0.187765 0.187765

JSON
----

  $ raylab explain three.scene --json 1,0
  {
    "version": 3,
    "pixels": [
      {
        "x": 1,
        "y": 0,
        "rgb": [ 51, 102, 153 ],
        "summary": "pixel (1, 0) is rgb 51 102 153: the blue background, since the ray hits nothing",
        "color": [ 0.2, 0.4, 0.6 ],
        "film": { "samples": 1, "exposure": 1.0, "srgb": false },
        "cause": null,
        "samples": [
          {
            "color": [ 0.2, 0.4, 0.6 ],
            "ray": {
              "origin": [ 0.0, 0.0, -4.0 ],
              "direction": [ 0.0, 0.0, 1.0 ],
              "reach": null,
              "seed": 491315723.0,
              "share": 1.0,
              "left": 4,
              "color": [ 0.2, 0.4, 0.6 ],
              "outcome": "missed",
              "hit": null,
              "terms": [
                { "source": "background", "color": [ 0.2, 0.4, 0.6 ] }
              ]
            }
          }
        ]
      }
    ]
  }
  $ raylab explain three.scene --json 0,0 2,0 1,0 | grep -o '"outcome": .*'
  "outcome": "hit",
  "outcome": "hit",
  "outcome": "hit",
  "outcome": "missed",
  $ raylab explain three.scene --json 0,0 2,0 1,0 | grep -o '"verdict": .*'
  "verdict": "lit",
  "verdict": "faces away",
  "verdict": "lit",
  "verdict": "faces away",
  $ raylab explain three.scene --json 0,0 | grep -A 7 '"object"'
                "object": {
                  "number": 1,
                  "line": 7,
                  "shape": {
                    "kind": "sphere",
                    "centre": [ -4.0, 0.5, 4.0 ],
                    "radius": 1.0
                  },
  --
                      "object": {
                        "number": 2,
                        "line": 8,
                        "shape": {
                          "kind": "plane",
                          "point": [ 0.0, -2.0, 0.0 ],
                          "normal": [ 0.0, 1.0, 0.0 ]
                        },

If both are asked for, that is a mistake.

  $ raylab explain three.scene --json --steps 1,0 2>&1 | sed '/^Usage/,$d'
  raylab: options '--json' and '--steps' cannot be present at the same time

A picture of the path
---------------------

It goes to a file; the text is printed as well.

  $ raylab explain three.scene 0,0 --svg path.svg > text
  $ raylab explain three.scene 0,0 | cmp - text
  $ head -c 39 path.svg; echo
  <svg xmlns="http://www.w3.org/2000/svg"
  $ grep -o '<title>.*' path.svg
  <title>pixel (0, 0) is rgb 73 37 0: a mirror (sphere 1, line 7) that shows the orange plane (object 2, line 8), lit by light 1, with light 2 behind it</title>
  $ grep -c '>sphere 1</text>' path.svg
  2
  $ raylab explain three.scene 0,0 --json --svg json.svg | head -n 2
  {
    "version": 3,
  $ cmp path.svg json.svg

Or to standard output, alone.

  $ raylab explain three.scene 0,0 --svg - | cmp - path.svg
  $ raylab explain three.scene 0,0 --json --svg -
  raylab: option --svg: only one thing can go to standard output
  [124]
  $ raylab explain three.scene 0,0 1,0 --svg both.svg
  raylab: option --svg: the picture is of the path of one pixel, not of several
  [124]
  $ raylab explain three.scene 0,0 --svg three.scene
  raylab: three.scene is the scene; the picture would replace it
  [124]
  $ raylab explain three.scene 0,0 --svg path.png
  raylab: path.png: the path of the rays is drawn as SVG, not as '.png'; use .svg
  [124]
  $ raylab explain three.scene 0,0 --svg .svg
  raylab: .svg: there is no name before the extension; put one there
  [124]
  $ raylab explain three.scene 0,0 --svg PATH.SVG > text && cmp path.svg PATH.SVG
  $ rm PATH.SVG
  $ raylab explain three.scene 0,0 --svg ''
  raylab: option --svg: the name of the file is empty
  [124]

The file appears whole or not at all.

  $ raylab explain three.scene 0,0 --svg missing/path.svg
  raylab: missing/path.svg: No such file or directory
  [2]
  $ raylab explain three.scene 0,0 --svg /dev/full
  raylab: /dev/full: No space left on device
  [2]
  $ echo older > old.svg
  $ (ulimit -f 0; raylab explain three.scene 0,0 --svg old.svg) 2>&1 | cat
  raylab: old.svg: File too large
  $ cat old.svg
  older
  $ ls -A
  in
  json.svg
  old.svg
  path.svg
  text
  three.ppm
  three.scene

Mistakes
--------

  $ raylab explain three.scene 3,0
  raylab: pixel 3,0 is not in the picture: x is from 0 to 2, y from 0 to 0
  [124]
  $ raylab explain three.scene 0,0 0,1
  raylab: pixel 0,1 is not in the picture: x is from 0 to 2, y from 0 to 0
  [124]
  $ raylab explain three.scene --size 640x480 640,0
  raylab: pixel 640,0 is not in the picture: x is from 0 to 639, y from 0 to 479
  [124]
  $ raylab explain three.scene -- -1,0
  raylab: pixel -1,0 is not in the picture: x is from 0 to 2, y from 0 to 0
  [124]
  $ usage () { raylab explain "$@" > out 2> err; code=$?; sed '/^Usage:/,$d' err; return $code; }
  $ usage three.scene 1
  raylab: X,Y… arguments: '1' is not a pixel: expected x, counted from the
          left, and y, from the top, such as 320,240
  [124]
  $ usage three.scene 1,0x
  raylab: X,Y… arguments: '1,0x' is not a pixel: expected x, counted from the
          left, and y, from the top, such as 320,240
  [124]
  $ usage three.scene 1,,0
  raylab: X,Y… arguments: '1,,0' is not a pixel: expected x, counted from the
          left, and y, from the top, such as 320,240
  [124]
  $ usage three.scene 1,99999999999999999999
  raylab: X,Y… arguments: '1,99999999999999999999' is not a pixel: expected
          x, counted from the left, and y, from the top, such as 320,240
  [124]
  $ usage three.scene
  raylab: required argument X,Y is missing
  [124]
  $ usage
  raylab: required arguments SCENE, X,Y are missing
  [124]
  $ cat out

A scene in error, and one that is not there.

  $ echo 'imWidth none' | raylab explain - 0,0 > out 2> err
  [1]
  $ head -n 1 err
  <standard input>:1:9-12: error: 'none' is not a number
  $ raylab explain missing.scene 0,0
  missing.scene: error: No such file or directory
  [1]
  $ cat out

Standard output that cannot be written to.

  $ raylab explain three.scene 0,0 > /dev/full
  raylab: standard output: No space left on device
  [2]
  $ raylab explain three.scene 0,0 >&-
  raylab: standard output: Bad file descriptor
  [2]
  $ raylab explain three.scene 0,0 --json --svg path.svg > /dev/full
  raylab: standard output: No space left on device
  [2]

A name can be hostile, and so can a comment: nothing of them is printed.

  $ hostile=$(printf '"<b>&\\\033[31m\n\302\233\377.scene')
  $ { cat three.scene; echo "# $hostile" | tr -d "\n"; } > "$hostile"
  $ for form in '' --json --steps --svg=-; do
  >   raylab explain three.scene 0,0 $form > plain
  >   raylab explain "$hostile" 0,0 $form | cmp - plain
  > done

The README
----------

It shows an explanation as it is.

  $ cd ../..
  $ sed -n 's/^    \$ raylab explain //p' README.md > pixel
  $ cat pixel
  scenes/first.scene 370,390
  $ awk '/^    \$ raylab explain/ { inside = 1; next }
  >      inside && /^[^ ]/ { exit }
  >      inside { sub(/^    /, ""); print }' README.md > shown
  $ { raylab explain $(cat pixel); echo; } | cmp - shown

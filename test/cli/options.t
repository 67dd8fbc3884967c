The options of a rendering. Its picture has detail everywhere: a mirror between
two walls, a sun and its shadow.

  $ unset DISPLAY
  $ cat > mirror.scene <<EOF
  > imWidth 60   imHeight 40   canvWidth 6   canvHeight 4   depth 4
  > bcolor 0.2 0.3 0.5
  > lights
  > directional 0.9 1 0.9 0.8  1 -2 1.5
  > spherical 9 white  -1 2 2
  > objects
  > plane 0 -1.5 0  0 1 0      diffusive 0.8 0.3 0.2
  > plane 0 0 9     0 0.2 -1   mixed 0.6 diffusive 0.2 0.8 0.4 0.4 reflective
  > sphere 0 0 4 1.4           mixed 0.2 diffusive red 0.8 reflective
  > EOF

-j: the picture is the same, byte for byte, on any number of domains.

  $ for j in 1 2 3 4 128; do
  >   raylab render mirror.scene -q -j $j -o $j.bmp
  >   raylab render mirror.scene -q --domains=$j --size 61x43 -o odd$j.bmp
  >   cmp 1.bmp $j.bmp && cmp odd1.bmp odd$j.bmp
  > done
  $ raylab render mirror.scene -q -o default.bmp
  $ cmp 1.bmp default.bmp

--size: as large as that, whatever the scene says.

  $ raylab render mirror.scene -q --size 7x5 -o small.ppm
  $ grep -a -m 1 '^[0-9]' small.ppm
  7 5
  $ raylab render mirror.scene -q --size 7X5 -o also.ppm
  $ cmp small.ppm also.ppm

A size that distorts the picture is told, unless the scene's own does it as much,
whole pixels come no nearer, or nothing is to be told.

  $ for size in 60x80 600x400 6x4 7x5; do
  >   raylab render mirror.scene --size $size -o small.ppm 2>&1 | grep -v wrote
  > done
  raylab: warning: --size 60x80 distorts the picture, which looks 2 times as high as it should; 60x40 would not
  [1]
  $ raylab explain mirror.scene --size 60x80 0,0 2>&1 > out | head -n 1
  raylab: warning: --size 60x80 distorts the picture, which looks 2 times as high as it should; 60x40 would not
  $ raylab slurm mirror.scene --size 60x80 --bands 2 -o job.png 2>&1 | head -n 1
  raylab: warning: --size 60x80 distorts the picture, which looks 2 times as high as it should; 60x40 would not
  $ rm -r out job.slurm
  $ sed 's/imWidth 60   imHeight 40/imWidth 60 imHeight 80/' mirror.scene > high.scene
  $ raylab render high.scene --size 120x160 -o small.ppm
  high.scene: warning: canvas and picture differ in proportions: the picture looks 2 times as high as it should
  raylab: wrote small.ppm
  $ raylab render mirror.scene --size 7x5 -q -o small.ppm

It is what the scene would show if it said so itself.

  $ sed 's/imWidth 60   imHeight 40/imWidth 7 imHeight 5/' mirror.scene > small.scene
  $ raylab render small.scene -q -o same.ppm
  $ cmp small.ppm same.ppm

--rows: only these, both included, counted from 0 at the top.

  $ raylab render mirror.scene -q -o all.ppm
  $ pixels () { tail -c $((3 * 60 * $1)) $2; }
  $ rows () {
  >   raylab render mirror.scene -q --rows $1-$2 -o rows.ppm $3 &&
  >   grep -a -m 1 '^[0-9]' rows.ppm &&
  >   pixels $(($2 - $1 + 1)) rows.ppm > got &&
  >   pixels $((40 - $1)) all.ppm | head -c $((3 * 60 * ($2 - $1 + 1))) |
  >     cmp - got
  > }
  $ rows 0 0
  60 1
  $ rows 13 29
  60 17
  $ rows 17 31 -j4
  60 15
  $ rows 39 39
  60 1
  $ rows 0 39
  60 40

They are rows of the size asked for, not of the scene's.

  $ raylab render mirror.scene -q --size 7x5 --rows 4-4 -o last.ppm
  $ tail -c 21 small.ppm > want
  $ tail -c 21 last.ppm | cmp - want

--grey: all three bytes of a pixel are the same.

  $ raylab render mirror.scene -q --grey -o grey.ppm
  $ pixels 40 grey.ppm | od -A n -v -t u1 -w3 | awk '$1 != $2 || $2 != $3'
  $ raylab render mirror.scene -q --gray -o gray.ppm
  $ cmp grey.ppm gray.ppm

They are the luminances of the scene's colours: 21.26 %, 71.52 % and 7.22 % of
255.

  $ for colour in red green blue white; do
  >   echo "imWidth 1 imHeight 1 canvWidth 1 canvHeight 1 depth 1
  >     plane 0 0 1 0 0 1 luminous $colour" > one.scene
  >   raylab render one.scene -q --grey -o one.ppm
  >   tail -c 3 one.ppm | od -A n -t u1
  > done
    54  54  54
   182 182 182
    18  18  18
   255 255 255

-q: nothing is said. Errors are.

  $ raylab -q mirror.scene
  $ raylab render mirror.scene --quiet -o a.png
  $ raylab render mirror.scene -q -o missing/a.png
  raylab: missing/a.png: No such file or directory
  [2]

--stats: the rays by kind, on standard error. All four rays hit a wall, which
asks for three lights: a wall behind the eye blocks the first, the second
reaches it, and the third shines on its other side, so no ray is sent. Half of
what the wall shows is mirrored: the wall behind the eye, which shines by itself
and needs neither light nor mirror.

  $ cat > two-walls.scene <<EOF
  > imWidth 2   imHeight 2   canvWidth 2   canvHeight 2   depth 1
  > lights
  > directional 1 white  0 0 1
  > spherical   1 white  0 0 0
  > directional 1 white  0 0 -1
  > objects
  > plane 0 0 10   0 0 1   mixed 0.5 diffusive white 0.5 reflective
  > plane 0 0 -20  0 0 1   luminous white
  > EOF
  $ stats () {
  >   raylab render two-walls.scene -q --stats "$@" 2>&1 >/dev/null |
  >     sed -E '/^time|per second/s/ +[0-9.]+/ N/; s/  +/ /'
  > }
  $ stats
  primary rays 4
  reflected rays 4
  shadow rays 8
  rays 16
  hits 8
  lights blocked 4
  pixels 4
  samples a pixel 1.000
  over-exposed 0.00 %
  time N s
  rays per second N

They are those of the rows that were rendered, on however many domains.

  $ stats --size 40x30 --rows 10-19 -j 4 | head -n 7
  primary rays 400
  reflected rays 400
  shadow rays 800
  rays 1600
  hits 800
  lights blocked 400
  pixels 400

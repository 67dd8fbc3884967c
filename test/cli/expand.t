"raylab check --expand" prints what has become of a scene.

  $ cat > tower.scene <<EOF
  > imWidth 4   imHeight 3   canvWidth 4   canvHeight 3   depth 4
  > include "ball.scene"
  > for i = 1 to 2
  >   ball(0.5 * i)
  > end
  > directional 1 white   1 -1 1
  > EOF
  $ echo 'let ball(r) = sphere 0 0 4 r diffusive red scaled 2' > ball.scene
  $ raylab check --expand tower.scene
  imWidth 4
  imHeight 3
  canvWidth 4
  canvHeight 3
  depth 4
  bcolor 0 0 0
  raydepth 4
  lights
  directional 1 1 1 1 0.5773502691896258 -0.5773502691896258 0.5773502691896258  # line 6
  objects
  sphere 0 0 8 1 diffusive 1 0 0  # line 1 of ball.scene, in ball(r: 0.5), i = 1, line 3
  sphere 0 0 8 2 diffusive 1 0 0  # line 1 of ball.scene, in ball(r: 1), i = 2, line 3

That reads back as the same scene, and so does that of every scene of the gallery,
in its folder, where its meshes are.

  $ cp -RL ../../scenes .
  $ expand () { raylab check --expand "$@" 2> /dev/null | sed 's/  # .*//'; }
  $ for scene in tower.scene scenes/*.scene; do
  >   expand $scene > first
  >   (cd $(dirname $scene) && expand -) < first > second
  >   cmp first second && [ -s first ] || echo $scene
  > done
  $ raylab render -q tower.scene -o a.ppm
  $ raylab check --expand tower.scene | raylab render -q - -o b.ppm
  $ cmp a.ppm b.ppm

It takes one scene, and says what is wrong with it.

  $ raylab check --expand tower.scene ball.scene
  raylab: option --expand: only one scene can be printed
  [124]
  $ raylab check --expand ball.scene
  ball.scene:1:52: error: the header lacks imWidth, imHeight, canvWidth, canvHeight, depth
      1 | let ball(r) = sphere 0 0 4 r diffusive red scaled 2
        |                                                    ^
  every scene starts with imWidth, imHeight, canvWidth, canvHeight and depth, each followed by a number
  [1]
  $ raylab check --expand tower.scene > /dev/full
  raylab: standard output: No space left on device
  [2]

Every file of the library can be included, all of them together, too.

  $ mv scenes/library .
  $ { head -n 1 tower.scene; echo 'directional 1 white 1 -1 1 sphere 0 0 4 1 reflective'; } > x.scene
  $ for file in library/*.scene; do
  >   { echo "include \"$file\""; cat x.scene; } > one.scene
  >   raylab check one.scene
  >   sed -n 's/^# *include "\(.*\)"$/\1/p' $file | grep -qx $file || echo "$file does not say how"
  >   grep -q "\"$file\"" scenes/*.scene || echo "$file is used by no scene"
  > done
  $ { for file in library/*.scene; do echo "include \"$file\""; done; cat x.scene; } > all.scene
  $ raylab check all.scene

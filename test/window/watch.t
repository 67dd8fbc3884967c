A scene is edited beside its window.

  $ . ./drive.sh
  $ start_server 1000x700
  $ cat > a.scene <<EOF
  > imWidth 120   imHeight 90   canvWidth 4   canvHeight 3   depth 4
  > bcolor 0.2 0.3 0.5
  > sphere 0 0 3 1  luminous red
  > EOF
  $ sed 's/red/green/' a.scene > green.scene
  $ sed 's/red/yellow/; s/120/160/' a.scene > yellow.scene
  $ sed 's/red/gren/' a.scene > broken.scene
  $ for scene in a green yellow; do picture $scene.scene > $scene.rgb; done
  $ cp a.scene red.scene && cp a.rgb red.rgb
  $ start a.scene view --watch a.scene
  $ until_ok is_picture a.rgb

An editor that writes into the file, and one that puts another in its place; the
second time the picture has another size.

  $ cat green.scene > a.scene
  $ until_ok is_picture green.rgb
  $ cp yellow.scene new && mv new a.scene
  $ until_ok is_picture yellow.rgb
  $ size
  160x90

One that first takes the old file away.

  $ mv a.scene a.scene~ && cat green.scene > a.scene
  $ until_ok is_picture green.rgb

An error is shown, and told whole. The last picture is behind it, darker.

  $ cp broken.scene new && mv new a.scene
  $ shows 'a.scene: error'
  $ until_ok told "a.scene:3:26-29: error: unknown colour 'gren'"
  $ raylab check a.scene 2> all || tail -n $(wc -l < all) err | diff all -
  $ until_ok is_not_picture green.rgb
  $ corner () { import -window "$window" -crop 1x1+119+89 -depth 8 txt:- | grep -o '#[0-9A-F]\{6\}'; }
  $ corner
  #0F1626

Nothing can be saved then. The file may even be away.

  $ press s
  $ until_ok told 'no picture to save'
  $ rm a.scene
  $ until_ok told 'No such file'

The right scene brings the picture back.

  $ cat red.scene > a.scene
  $ until_ok is_picture a.rgb

A change stops a rendering that would take hours.

  $ { sed '$d' a.scene; echo 'raydepth 100000'
  >   echo 'plane 0 0 9 0 0 1 reflective   plane 0 0 -9 0 0 1 reflective'
  > } > hall.scene
  $ cat hall.scene > a.scene
  $ shows '%$'
  $ cat green.scene > a.scene
  $ until_ok is_picture green.rgb
  $ press q
  $ ended

A scene that is in error from the start has a window, too, if it is watched.

  $ cp broken.scene b.scene
  $ start b.scene view --watch b.scene
  $ shows error
  $ size
  640x480
  $ cat green.scene > b.scene
  $ until_ok is_picture green.rgb
  $ press q
  $ ended

Files that are included are watched, too, also one that is not there yet.

  $ mkdir parts
  $ { head -n 2 a.scene; echo 'include "parts/ball.scene"'; } > c.scene
  $ start c.scene view --watch c.scene
  $ until_ok told 'cannot be included'
  $ tail -n 1 a.scene > parts/ball.scene
  $ until_ok is_picture green.rgb
  $ tail -n 1 red.scene > parts/new && mv parts/new parts/ball.scene
  $ until_ok is_picture red.rgb
  $ press q
  $ ended
  $ raylab view broken.scene 2>&1 | head -n 1
  broken.scene:3:26-29: error: unknown colour 'gren'
  $ raylab view --watch - < a.scene
  raylab: option --watch: standard input cannot be watched
  [124]

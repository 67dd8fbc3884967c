What README.md says of scenes is true.

The picture at its top is that of the first command:

  $ is_picture () { convert "$1" -depth 8 rgb:- | cmp - "$2"; }
  $ pixels () { raylab render "$1" -q -o p.ppm $3 && tail -c $2 p.ppm; }
  $ options=$(sed -n 's/.*render scenes.first.scene \(.*\) -o first.bmp$/\1/p' ../../README.md)
  $ pixels ../../scenes/first.scene $((640 * 480 * 3)) "$options" > first.rgb
  $ is_picture ../../doc/first.png first.rgb

The scene in it has no error, and its picture is the one below it:

  $ sed -n '/^## A scene/,/^## Using/s/^    //p' ../../README.md > block
  $ sed '/^my.scene/,$d' block > my.scene
  $ raylab check my.scene
  $ pixels my.scene $((480 * 270 * 3)) > scene.rgb
  $ is_picture ../../doc/scene.png scene.rgb

The mistake in it is answered as it says:

  $ sed -n '/^my.scene/,$p' block > promised
  $ sed -i 's/mixed .*/difuse red/' my.scene
  $ raylab check my.scene 2> answer
  [1]
  $ diff promised answer

Its commands are those that there are:

  $ sed -n '/^## Using/,/^##/s/^    raylab \([a-z]\+\) .*/\1/p' ../../README.md |
  >   sort > shown
  $ raylab --help=plain | sed -n '/^COMMANDS/,/^ARGUMENTS/p' |
  >   sed -n 's/^ \{7\}\([a-z]\+\) .*/\1/p' | sort | diff shown -

So are the files to which it links:

  $ cd ../..
  $ grep -o '](\([^)]*\))' README.md | tr -d '](){}' | xargs ls -d > /dev/null

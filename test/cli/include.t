Scenes of several files. test/language/test_include.ml tells what they mean.

  $ mkdir -p house/parts shared out
  $ cat > house/main.scene <<EOF
  > include "parts/base.scene"
  > imWidth 16 imHeight 12
  > include "parts/wood.scene"
  > ball(0)
  > EOF
  $ cat > house/parts/base.scene <<EOF
  > canvWidth 4 canvHeight 3 depth 4
  > include "wood.scene"
  > plane 0 -1 0   0 1 0   oak
  > directional 1 white 1 -1 1
  > EOF
  $ cat > house/parts/wood.scene <<EOF
  > let oak = diffusive 0.5 0.3 0.1
  > let ball(x) = sphere x 0 4 0.5 oak
  > EOF
  $ cp house/parts/wood.scene shared
  $ raylab check house/main.scene
  $ raylab render -q house/main.scene -o out/a.png
  $ raylab explain house/main.scene 8,6 | head -5
  pixel (8, 6) is rgb 0 0 0: a brown sphere (object 2, line 2 of
  parts/wood.scene, in ball(x: 0), line 4), facing away from light 1, so that
  no light reaches it
  
  ray 1: (0, 0, -4) + t (0.0312195, -0.0312195, 0.999025), 4 left in the chain

No picture replaces one of the files.

  $ ln -s parts/wood.scene house/wood.png
  $ ln house/parts/base.scene house/base.svg
  $ raylab render house/main.scene -o house/wood.png
  raylab: house/wood.png is a file of the scene; the picture would replace it
  [124]
  $ raylab view house/main.scene -o house/wood.png
  raylab: house/wood.png is a file of the scene; the picture would replace it
  [124]
  $ raylab slurm house/main.scene -o house/wood.png --bands 2
  raylab: house/wood.png is a file of the scene; the picture would replace it
  [124]
  $ raylab explain house/main.scene 8,6 --svg house/base.svg
  raylab: house/base.svg is a file of the scene; the picture would replace it
  [124]
  $ raylab check house/main.scene
  $ rm house/wood.png house/base.svg

Names are relative to the file that names them, wherever one works; of standard
input to the current folder.

  $ (cd house/parts && raylab render -q ../main.scene -o ../../out/b.png)
  $ (cd house && raylab render -q - -o ../out/c.png < main.scene)
  $ (cd house && raylab render -q /dev/stdin -o ../out/d.png < main.scene)
  $ (cd house && cat main.scene | raylab render -q /dev/stdin -o ../out/e.png)
  $ (cd house && raylab render -q main.scene -o ../out/f.png < main.scene)
  $ for picture in out/*.png; do cmp out/a.png $picture; done
  $ raylab check - < house/main.scene
  <standard input>:1:9-26: error: 'parts/base.scene' cannot be included: no such file or directory
      1 | include "parts/base.scene"
        |         ^^^^^^^^^^^^^^^^^^
  <standard input>:3:9-26: error: 'parts/wood.scene' cannot be included: no such file or directory
      3 | include "parts/wood.scene"
        |         ^^^^^^^^^^^^^^^^^^
  [1]

Files are in the folder of the scene or below it, after links are resolved, or in
a folder that is allowed. Nothing else is read.

  $ scene () { printf 'imWidth 4 imHeight 3 canvWidth 4 canvHeight 3 depth 4\n%s\n' "$1" > house/x.scene; }
  $ scene 'include "../shared/wood.scene" ball(0)'
  $ raylab check house/x.scene
  house/x.scene:2:9-30: error: '../shared/wood.scene' cannot be included: it lies outside of the folder of the scene
      2 | include "../shared/wood.scene" ball(0)
        |         ^^^^^^^^^^^^^^^^^^^^^^
  if it may be read, say so: --allow and the folder in which it is
  [1]
  $ raylab check house/x.scene --allow nowhere 2>&1 | head -n 1
  raylab: option '--allow': there is no 'nowhere'
  $ raylab check house/x.scene --allow shared/wood.scene 2>&1 | head -n 1
  raylab: option '--allow': 'shared/wood.scene' is not a folder
  $ raylab check house/x.scene --allow house --allow shared
  house/x.scene: warning: there is no light: diffusive surfaces are black
  $ raylab render -q house/x.scene --allow . -o out/x.png
  $ raylab explain house/x.scene 2,1 --allow shared | head -2
  house/x.scene: warning: there is no light: diffusive surfaces are black
  pixel (2, 1) is rgb 0 0 0: the black background, since the ray hits nothing
  
  $ ln -s ../shared/wood.scene house/link.scene
  $ scene 'include "link.scene" ball(0)'
  $ raylab check house/x.scene
  house/x.scene:2:9-20: error: 'link.scene' cannot be included: it lies outside of the folder of the scene
      2 | include "link.scene" ball(0)
        |         ^^^^^^^^^^^^
  if it may be read, say so: --allow and the folder in which it is
  [1]
  $ raylab check house/x.scene --allow shared
  house/x.scene: warning: there is no light: diffusive surfaces are black
  $ ln -s parts/wood.scene house/inside.scene
  $ scene 'include "inside.scene" include "parts/wood.scene" ball(0)'
  $ raylab check house/x.scene
  house/x.scene: warning: there is no light: diffusive surfaces are black
  $ ln -s house other
  $ raylab check other/x.scene
  other/x.scene: warning: there is no light: diffusive surfaces are black
  $ scene 'include "/etc/passwd" include "/etc/nothing" include "../../nothing"'
  $ raylab check house/x.scene
  house/x.scene:2:9-21: error: '/etc/passwd' cannot be included: it lies outside of the folder of the scene
      2 | include "/etc/passwd" include "/etc/nothing" include "../../nothing"
        |         ^^^^^^^^^^^^^
  if it may be read, say so: --allow and the folder in which it is
  house/x.scene:2:31-44: error: '/etc/nothing' cannot be included: it lies outside of the folder of the scene
      2 | include "/etc/passwd" include "/etc/nothing" include "../../nothing"
        |                               ^^^^^^^^^^^^^^
  if it may be read, say so: --allow and the folder in which it is
  house/x.scene:2:54-68: error: '../../nothing' cannot be included: it lies outside of the folder of the scene
      2 | include "/etc/passwd" include "/etc/nothing" include "../../nothing"
        |                                                      ^^^^^^^^^^^^^^^
  if it may be read, say so: --allow and the folder in which it is
  [1]

What is no file of text is not read, and nothing waits for it.

  $ mkfifo house/pipe
  $ truncate -s 3G house/large
  $ scene 'include "pipe" include "parts" include "large" include "none" include ""'
  $ raylab check house/x.scene
  house/x.scene:2:9-14: error: 'pipe' cannot be included: it is a pipe, not a file
      2 | include "pipe" include "parts" include "large" include "none" include ""
        |         ^^^^^^
  house/x.scene:2:24-30: error: 'parts' cannot be included: it is a folder, not a file
      2 | include "pipe" include "parts" include "large" include "none" include ""
        |                        ^^^^^^^
  house/x.scene:2:40-46: error: 'large' cannot be included: it has more than the 2147483520 bytes that are left for it
      2 | include "pipe" include "parts" include "large" include "none" include ""
        |                                        ^^^^^^^
  house/x.scene:2:56-61: error: 'none' cannot be included: no such file or directory
      2 | include "pipe" include "parts" include "large" include "none" include ""
        |                                                        ^^^^^^
  house/x.scene:2:71-72: error: '' cannot be included: the name of the file is empty
      2 | include "pipe" include "parts" include "large" include "none" include ""
        |                                                                       ^^
  [1]
  $ scene 'include "/dev/zero"'
  $ raylab check house/x.scene --allow /dev
  house/x.scene:2:9-19: error: '/dev/zero' cannot be included: it is a device, not a file
      2 | include "/dev/zero"
        |         ^^^^^^^^^^^
  [1]

A circle is shown, and names of files control no terminal.

  $ echo 'include "x.scene"' > house/y.scene
  $ scene 'include "y.scene"'
  $ raylab check house/x.scene
  house/y.scene:1:9-17: error: files include each other in a circle
      1 | include "x.scene"
        |         ^^^^^^^^^
  house/x.scene includes "y.scene" in line 2,
  y.scene includes "x.scene" in line 1
  [1]
  $ scene "$(printf 'include "\033[31m"')"
  $ raylab check house/x.scene | cat -v
  house/x.scene:2:9-15: error: '�[31m' cannot be included: no such file or directory
      2 | include "�[31m"
        |         ^^^^^^^
  $ echo 'let a = 1 sphere' > "$(printf 'house/\033[31m')"
  $ raylab check house/x.scene 2>&1 | cat -v
  house/M-oM-?M-=[31m:2:1: error: the file ends where a number should follow
      2 | 
        | ^
  expected the centre of the sphere: sphere CENTRE RADIUS, the centre being
  three numbers, x y z.

A band knows all files: after a change of one it is of another picture.

  $ cd house
  $ raylab render -q main.scene --rows 0-5 -o ../out/1.png
  $ sed -i 's/0.5 0.3/0.6 0.3/' parts/wood.scene
  $ raylab render -q main.scene --rows 6-11 -o ../out/2.png
  $ raylab join ../out/1.png ../out/2.png -o ../out/both.png
  raylab: ../out/1.png and ../out/2.png are not of one picture: the scenes differ
  [1]
  $ cd ..

A job for Slurm has copies of all files, where the copy of the scene names them.

  $ raylab slurm house/main.scene -o out/job.png --bands 2 2> /dev/null
  $ (cd out/job.slurm && find . -name '*.scene' | sort)
  ./parts/base.scene
  ./parts/wood.scene
  ./picture.scene
  $ cmp house/main.scene out/job.slurm/picture.scene
  $ diff -r house/parts out/job.slurm/parts
  $ raylab render -q out/job.slurm/picture.scene -o out/j.png
  $ raylab render -q house/main.scene -o out/k.png && cmp out/j.png out/k.png

A name that a file cannot have there is changed where it is included.

  $ mkdir house/log && echo 'include "../../shared/wood.scene"' > house/log/picture.scene
  $ scene 'include "log/picture.scene" ball(0)'
  $ raylab slurm house/x.scene -o out/x.png --bands 2 --allow shared 2> /dev/null
  $ (cd out/x.slurm && grep -r include *.scene included)
  picture.scene:include "included/1/picture.scene" ball(0)
  included/1/picture.scene:include "../2/wood.scene"

At the prompt the same holds.

  $ echo 'print_int (List.length (scene ()).objects);; load "house/main.scene";;' > count.ml
  $ scene 'include "../shared/wood.scene" ball(0)'
  $ raylab repl house/x.scene count.ml
  house/x.scene:2:9-30: error: '../shared/wood.scene' cannot be included: it lies outside of the folder of the scene
      2 | include "../shared/wood.scene" ball(0)
        |         ^^^^^^^^^^^^^^^^^^^^^^
  if it may be read, say so: --allow and the folder in which it is
  [1]
  $ raylab repl house/x.scene count.ml --allow shared
  house/x.scene: warning: there is no light: diffusive surfaces are black
  1house/main.scene: 2 objects, 1 light, 16 x 12 pixels

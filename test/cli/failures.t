Pictures that cannot be written: exit status 2, an older file untouched, and
nothing left behind.

  $ unset DISPLAY
  $ cat > sky.scene <<EOF
  > imWidth 4   imHeight 3   canvWidth 4   canvHeight 3   depth 4
  > bcolor 0.2 0.4 0.6
  > lights spherical 20 white 0 3 3
  > plane 0 -1 0  0 1 0   diffusive white
  > EOF

  $ raylab render sky.scene -o missing/sky.bmp
  raylab: missing/sky.bmp: No such file or directory
  [2]
  $ mkdir dir
  $ raylab render sky.scene -o dir
  raylab: dir: is a directory
  [2]
  $ raylab render sky.scene -o dir/
  raylab: dir/: is a directory
  [2]
  $ raylab render sky.scene -o new/
  raylab: new/: Not a directory
  [2]
  $ raylab render sky.scene -o sky.scene/sky.bmp
  raylab: sky.scene/sky.bmp: Not a directory
  [2]
  $ raylab render sky.scene -o /dev/full
  raylab: /dev/full: No space left on device
  [2]
  $ raylab render sky.scene -o $(printf '%0300d' 0).bmp 2>&1 | grep -o '[^:]*$'
   File name too long
  $ mkdir sky.bmp
  $ raylab sky.scene
  raylab: sky.bmp: is a directory
  [2]
  $ rmdir sky.bmp

A file that may not grow is like a full disk; here it may not even start. What
fails then depends on the size and the format.

  $ limited () {
  >   (ulimit -f $1; shift; raylab "$@"; echo "[$?]") 2>&1 | cat
  > }
  $ for format in bmp ppm; do
  >   echo older > old.$format
  >   limited 0 render sky.scene -o old.$format
  >   limited 0 render sky.scene -o new.$format
  >   limited 4 render sky.scene -q --size 300x200 -o old.$format
  >   limited 4 render sky.scene -q --size 300x200 -o new.$format
  >   cat old.$format
  > done
  raylab: old.bmp: File too large
  [2]
  raylab: new.bmp: File too large
  [2]
  raylab: old.bmp: File too large
  [2]
  raylab: new.bmp: File too large
  [2]
  older
  raylab: old.ppm: File too large
  [2]
  raylab: new.ppm: File too large
  [2]
  raylab: old.ppm: File too large
  [2]
  raylab: new.ppm: File too large
  [2]
  older

A PNG fails in other words, which depend on who noticed.

  $ echo older > old.png
  $ for run in '0 render sky.scene' '4 render sky.scene --size 300x200'; do
  >   for file in old.png new.png; do
  >     limited $run -o $file | sed -n 's/^raylab: \([a-z]*.png:\) .*/\1/p; /^[[]/p'
  >   done
  > done
  old.png:
  [2]
  new.png:
  [2]
  old.png:
  [2]
  new.png:
  [2]
  $ cat old.png
  older

Such a small picture can be written if there is room for it.

  $ limited 4 render sky.scene -q -o new.png
  [0]

No folder for temporary files is needed: files are made where they belong, and
what is for standard output, a pipe or a device goes there at once.

  $ export TMPDIR=/missing
  $ raylab render sky.scene -q -o new.bmp
  $ raylab render sky.scene -o - | cmp - new.bmp
  $ mkfifo pipe
  $ cmp new.bmp - < pipe & raylab render sky.scene -q -o pipe; wait; rm pipe
  $ raylab render sky.scene -q --rows 0-2 -o band.ppm
  $ raylab join band.ppm -o - | cmp - new.bmp
  $ raylab explain sky.scene 1,1 --svg path.svg > text
  $ raylab explain sky.scene 1,1 --svg - | cmp - path.svg
  $ rm band.ppm path.svg text
  $ raylab render sky.scene -o - > /dev/full
  raylab: standard output: No space left on device
  [2]
  $ unset TMPDIR

Nothing is left of the failures.

  $ rm new.png new.bmp
  $ ls -A . dir
  .:
  dir
  old.bmp
  old.png
  old.ppm
  sky.scene
  
  dir:

Too large
---------

A picture that cannot be made is refused at once, before there is room made for
it.

  $ sed 's/imWidth 4/imWidth 2000000000/' sky.scene > wide.scene
  $ raylab wide.scene
  raylab: a picture of 2000000000 x 3 pixels would take 16.8 GiB of memory; the limit is 4 GiB
  [2]
  $ sed 's/imHeight 3/imHeight 2000000000/' wide.scene > huge.scene
  $ raylab huge.scene
  raylab: a picture of 2000000000 x 2000000000 pixels would take 11175870895.4 GiB of memory; the limit is 4 GiB
  [2]
  $ raylab render sky.scene --size 2147483647x2147483647
  raylab: a picture of 2147483647 x 2147483647 pixels would take 12884901876.0 GiB of memory; the limit is 4 GiB
  [2]

Some rows of it are not too large, nor is a smaller size.

  $ raylab render huge.scene --size 4x3 -q -o small.ppm
  $ raylab render sky.scene -q -o same.ppm
  $ cmp small.ppm same.ppm
  $ raylab render sky.scene -q --size 3x2000000000 --rows 1999999999-1999999999 -o row.ppm
  $ tail -c 9 row.ppm | wc -c
  9

In a folder that is gone
------------------------

What is relative to it cannot be found, and all else is as ever.

  $ top=$PWD
  $ in_gone () {
  >   mkdir "$top/gone" && cd "$top/gone" && rmdir "$top/gone"
  >   raylab "$@"; code=$?; cd "$top"; return $code
  > }
  $ in_gone slurm "$top/sky.scene" -o sky.png --bands 2
  raylab: sky.png is relative to the current folder, which cannot be found: No such file or directory
  [2]
  $ in_gone slurm "$top/sky.scene" -o "$top/sky.png" --bands 2 2> /dev/null
  $ ls sky.slurm
  bands
  bands.sbatch
  join.sbatch
  log
  picture.scene
  submit
  $ rm -r sky.slurm
  $ in_gone render "$top/sky.scene" -o sky.png
  raylab: sky.png: No such file or directory
  [2]
  $ in_gone explain "$top/sky.scene" 0,0 --svg path.svg
  raylab: path.svg: No such file or directory
  [2]
  $ in_gone check sky.scene
  sky.scene: error: No such file or directory
  [1]
  $ in_gone join a.ppm -o b.ppm
  raylab: b.ppm: No such file or directory
  [2]
  $ in_gone repl "$top/sky.scene" script.ml
  Cannot find file script.ml.
  [2]
  $ in_gone render "$top/sky.scene" -q -o "$top/here.png" && rm here.png
  $ in_gone explain "$top/sky.scene" 0,0 | head -n 1
  pixel (0, 0) is rgb 51 102 153: the blue background, since the ray hits
  $ in_gone check "$top/sky.scene"
  $ echo 'why 0 0;; save "s.png"' | in_gone repl "$top/sky.scene"
  pixel (0, 0) is rgb 51 102 153: the blue background, since the ray hits nothing
  - : unit = ()
  Exception: Sys_error "s.png: No such file or directory".

Interrupted
-----------

This picture, of two mirrors that face each other, would take hours. After a
second it is interrupted, or ended in another way, and no file is there, new or
half; an older one is what it was.

  $ mkdir long && cd long
  $ cat > hall.scene <<EOF
  > imWidth 640   imHeight 480   canvWidth 4   canvHeight 3   depth 4
  > raydepth 1000000
  > plane 0 0 9 0 0 1 reflective   plane 0 0 -9 0 0 1 reflective
  > EOF
  $ by_default="env --default-signal=INT,HUP,TERM"
  $ end_by () {
  >   timeout --preserve-status -k 20 -s $1 1 \
  >     $by_default raylab render hall.scene -j 2 -o $2
  > }
  $ echo older > old.bmp
  $ end_by INT old.bmp
  [130]
  $ end_by TERM old.bmp
  [143]
  $ end_by HUP new.ppm
  [129]
  $ cat old.bmp
  older
  $ ls -A
  hall.scene
  old.bmp

One that waits for its reader is interrupted too, and leaves nothing where it
had made the picture.

  $ mkfifo pipe && mkdir tmp
  $ for signal in INT TERM HUP; do
  >   TMPDIR=$PWD/tmp timeout --preserve-status -k 20 -s $signal 1 \
  >     $by_default raylab render ../sky.scene --size 640x480 -o - <> pipe >&0
  >   test $? -gt 128 || echo "not ended by $signal"
  > done
  $ ls -A tmp

It dies of the signal itself, for the sake of loops in a shell: see progress.t. One
that is ignored when raylab starts, as after nohup, stays ignored. Here it is sent
once raylab has handlers for the others.

  $ (trap '' HUP; exec raylab render hall.scene -o new.ppm) & pid=$!
  $ has_handlers () {
  >   grep -q '^Name:.*raylab' /proc/$pid/status &&
  >     ! grep -q '^SigCgt:.*0000$' /proc/$pid/status
  > }
  $ for try in $(seq 600); do has_handlers && break; sleep 0.05; done
  $ kill -HUP $pid; kill -TERM $pid; wait $pid 2> /dev/null
  [143]

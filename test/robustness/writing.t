Faults while a picture is written. More of them are in ../cli/failures.t.

  $ unset DISPLAY
  $ cat > sky.scene <<EOF
  > imWidth 4   imHeight 3   canvWidth 4   canvHeight 3   depth 4
  > bcolor 0.2 0.4 0.6   sphere 0 0 -9 1 luminous white
  > EOF

No permission
-------------

To root nothing is forbidden, so these run as nobody.

  $ raylab=$(command -v raylab)
  $ top=$(mktemp -d) && chmod 755 $top && cp $raylab sky.scene $top && cd $top
  $ as_nobody () {
  >   if test $(id -u) = 0; then setpriv --reuid 65534 --regid 65534 --clear-groups "$@"
  >   else "$@"; fi
  > }
  $ mkdir locked && echo older > locked/old.bmp && chmod 555 locked
  $ mkdir open && chmod 777 open && echo older > open/old.bmp && chmod 444 open/old.bmp
  $ as_nobody ./raylab render sky.scene -o locked/new.bmp
  raylab: locked/new.bmp: Permission denied
  [2]
  $ as_nobody ./raylab render sky.scene -o locked/old.bmp
  raylab: locked/old.bmp: Permission denied
  [2]
  $ as_nobody ./raylab render sky.scene -o open/old.bmp
  raylab: open/old.bmp: Permission denied
  [2]
  $ cat locked/old.bmp open/old.bmp
  older
  older
  $ ls -A locked open
  locked:
  old.bmp
  
  open:
  old.bmp

In a folder that takes no new files, a file that may be written is written. That
costs something, which is told. The temporary file is in the folder for such
files, where there must be room then; this is known before.

  $ mkdir tmp && chmod 777 tmp && chmod 666 locked/old.bmp
  $ ./raylab render sky.scene -q -o sky.bmp
  $ TMPDIR=$PWD/tmp as_nobody ./raylab render sky.scene -o locked/old.bmp
  raylab: wrote locked/old.bmp by copying over what was there, for it cannot be replaced (no file can be made in its folder: Permission denied). Had that failed, neither the older nor the new one would be whole
  $ cmp sky.bmp locked/old.bmp
  $ TMPDIR=/missing as_nobody ./raylab render sky.scene -o locked/old.bmp
  raylab: locked/old.bmp: no file can be made in its folder (Permission denied), nor in /missing, the folder for temporary files (No such file or directory)
  [2]
  $ ln -s locked/old.bmp path.svg
  $ TMPDIR=$PWD/tmp as_nobody ./raylab explain sky.scene 1,1 --svg path.svg > text
  raylab: wrote path.svg by copying over what was there, for it cannot be replaced (no file can be made in its folder: Permission denied). Had that failed, neither the older nor the new one would be whole
  $ TMPDIR=$PWD/tmp as_nobody ./raylab explain sky.scene 1,1 --svg - | cmp - locked/old.bmp
  $ ls -A locked tmp
  locked:
  old.bmp
  
  tmp:

Owner and mode
--------------

They stay. This shows something only if root runs it.

  $ mkdir theirs && echo older > theirs/old.bmp && chmod 640 theirs/old.bmp
  $ if test $(id -u) = 0; then chown 65534:65533 theirs theirs/old.bmp; fi
  $ before=$(stat -c '%u %g %a' theirs/old.bmp)
  $ ./raylab render sky.scene -q -o theirs/old.bmp
  $ cmp sky.bmp theirs/old.bmp
  $ test "$(stat -c '%u %g %a' theirs/old.bmp)" = "$before"

The folder goes away
--------------------

  $ cat > slow.scene <<EOF
  > imWidth 200   imHeight 200   canvWidth 4   canvHeight 4   depth 4
  > raydepth 400
  > plane 0 0 9 0 0 1 reflective   plane 0 0 -9 0 0 1 reflective
  > EOF
  $ mkdir gone
  $ (sleep 0.2; rm -r gone) & ./raylab render slow.scene -j 1 -o gone/a.bmp; echo "[$?]"; wait
  raylab: gone/a.bmp: No such file or directory
  [2]

Killed
------

A kill that no program can answer, while the picture is written: the older file
is whole.

  $ await_part () {
  >   for try in $(seq 500); do ls -A $1 | grep -q ${2:-part} && break; sleep 0.01; done
  > }
  $ mkdir killed && echo older > killed/old.ppm
  $ ./raylab render sky.scene -q --size 6000x6000 -o killed/old.ppm & pid=$!
  $ await_part killed; kill -9 $pid; wait $pid 2> /dev/null
  [137]
  $ cat killed/old.ppm
  older

Ended during the write, it leaves nothing else there.

  $ rm -f killed/.raylab*
  $ ulimit -c 0
  $ for signal in INT TERM QUIT XCPU; do
  >   env --default-signal ./raylab render sky.scene -q --size 6000x6000 \
  >     -o killed/old.ppm & pid=$!
  >   await_part killed; kill -$signal $pid; wait $pid 2> /dev/null; echo "[$?]"
  >   ls -A killed; cat killed/old.ppm
  > done
  [130]
  old.ppm
  older
  [143]
  old.ppm
  older
  [131]
  old.ppm
  older
  [152]
  old.ppm
  older

Nor when it is tried whether there is room, before a rendering that would take
hours here.

  $ cat > hall.scene <<EOF
  > imWidth 6000   imHeight 6000   canvWidth 4   canvHeight 4   depth 4
  > raydepth 1000000
  > plane 0 0 9 0 0 1 reflective   plane 0 0 -9 0 0 1 reflective
  > EOF
  $ ./raylab render hall.scene -q -o killed/old.ppm & pid=$!
  $ await_part killed room; kill $pid; wait $pid 2> /dev/null
  [143]
  $ ls -A killed
  old.ppm

Nor does it mind if that was taken away already.

  $ mkdir away
  $ (exec ./raylab render sky.scene -q --size 6000x6000 -o away/new.ppm) & pid=$!
  $ await_part away; kill -STOP $pid; rm -r away; kill -TERM $pid; kill -CONT $pid
  $ wait $pid 2> /dev/null
  [143]
  $ cd / && rm -r $top

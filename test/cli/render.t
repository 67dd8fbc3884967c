What a rendering writes, and where. This scene's picture has two rows: sky, and
a floor that shines by itself.

  $ unset DISPLAY
  $ cat > floor.scene <<EOF
  > imWidth 2   imHeight 2   canvWidth 2   canvHeight 2   depth 1
  > bcolor 0 0 1
  > plane 0 -1 0  0 1 0   luminous 1 0.5 0
  > EOF
  $ bytes () { od -A n -v -t u1 "$@"; }

Without a command the picture goes beside the scene, wherever that is.

  $ raylab floor.scene
  raylab: wrote floor.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ mkdir deep
  $ cp floor.scene deep/no-extension
  $ raylab deep/no-extension
  raylab: wrote deep/no-extension.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ cmp floor.bmp deep/no-extension.bmp

So it does with the command, and with options before and after the scene.

  $ rm floor.bmp
  $ raylab render floor.scene
  raylab: wrote floor.bmp
  $ cmp floor.bmp deep/no-extension.bmp
  $ raylab -j 1 floor.scene -o a.bmp
  raylab: wrote a.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ raylab floor.scene -j 1 -o b.bmp
  raylab: wrote b.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ cmp a.bmp b.bmp
  $ ls -A
  a.bmp
  b.bmp
  deep
  floor.bmp
  floor.scene

A scene whose name starts with a dash comes after "--".

  $ cp floor.scene ./-floor.scene
  $ raylab render -o dash.bmp -- -floor.scene
  raylab: wrote dash.bmp

A scene that is called as a command is needs a path.

  $ cp floor.scene check
  $ raylab ./check
  raylab: wrote ./check.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown

Only ".scene" and ".txt" make room for the picture's extension. What else may
follow a point is part of the name, so that no picture takes another's place.

  $ mkdir names && cd names
  $ for name in run_0.05 run_0.10 run_0.05.scene b.TXT c.old.scene d.bmp; do
  >   cp ../floor.scene $name && raylab render $name
  > done
  raylab: wrote run_0.05.bmp
  raylab: wrote run_0.10.bmp
  raylab: wrote run_0.05.bmp
  raylab: wrote b.bmp
  raylab: wrote c.old.bmp
  raylab: wrote d.bmp.bmp
  $ cd ..

The formats
-----------

A BMP starts with BM and its own length; width and height follow, then 24, the
bits of a pixel. The rows are at the end, the lowest first, blue before red, and
filled up to a multiple of four bytes. Where they start is told as well.

  $ head -c 2 floor.bmp
  BM
  $ number () {
  >   bytes -j $1 -N 4 floor.bmp |
  >     awk '{ print $1 + 256 * ($2 + 256 * ($3 + 256 * $4)) }'
  > }
  $ test $(number 2) = $(wc -c < floor.bmp)
  $ test $(($(number 10) + 2 * 8)) = $(number 2)
  $ bytes -j 18 -N 8 floor.bmp
     2   0   0   0   2   0   0   0
  $ bytes -j 28 -N 1 floor.bmp
    24
  $ tail -c 16 floor.bmp | bytes -w8
     0 128 255   0 128 255   0   0
   255   0   0 255   0   0   0   0

A PNG starts with eight bytes that nothing else starts with; width and height
come after sixteen. Its last chunk has a fixed text.

  $ raylab render floor.scene -o floor.png
  raylab: wrote floor.png
  $ bytes -N 8 floor.png
   137  80  78  71  13  10  26  10
  $ bytes -j 16 -N 8 floor.png
     0   0   0   2   0   0   0   2
  $ tail -c 8 floor.png | bytes
    73  69  78  68 174  66  96 130

A PPM's header is text. The rows follow, the topmost first.

  $ raylab render floor.scene -o floor.ppm
  raylab: wrote floor.ppm
  $ head -c 2 floor.ppm
  P6
  $ head -n 3 floor.ppm | tail -n 2
  2 2
  255
  $ tail -c 12 floor.ppm | bytes -w6
     0   0 255   0   0 255
   255 128   0 255 128   0

Case does not matter. A name without extension is a BMP, also if its directory
has a dot.

  $ raylab render floor.scene -o FLOOR.PPM
  raylab: wrote FLOOR.PPM
  $ cmp floor.ppm FLOOR.PPM
  $ mkdir v1.png
  $ raylab render floor.scene -o v1.png/floor
  raylab: wrote v1.png/floor
  $ cmp floor.bmp v1.png/floor

Where there is no extension, and if nothing is said of the picture's name, the
format may be.

  $ raylab render floor.scene -o floor --format ppm && cmp floor floor.ppm
  raylab: wrote floor
  $ rm floor.png
  $ raylab render floor.scene --format png
  raylab: wrote floor.png
  $ raylab render floor.scene -o a.png --format png && cmp a.png floor.png
  raylab: wrote a.png

Replacing
---------

A picture that is already there is replaced, and keeps its permissions. Nothing
is left beside it.

  $ mkdir old && cd old && cp ../floor.scene .
  $ echo older > floor.bmp
  $ chmod 640 floor.bmp
  $ raylab floor.scene
  raylab: wrote floor.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ cmp floor.bmp ../floor.bmp
  $ stat -c %a floor.bmp
  640
  $ ls -A
  floor.bmp
  floor.scene

A new one gets those that any program's file gets.

  $ (umask 027; raylab floor.scene -o new.bmp)
  raylab: wrote new.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ stat -c %a new.bmp
  640

A link is followed.

  $ echo older > target
  $ ln -s target link.bmp
  $ raylab floor.scene -o link.bmp
  raylab: wrote link.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ readlink link.bmp
  target
  $ cmp target ../floor.bmp

What is not a file, such as a pipe, is written to.

  $ mkfifo pipe.ppm
  $ cat pipe.ppm > copy.ppm &
  $ raylab floor.scene -o pipe.ppm
  raylab: wrote pipe.ppm
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ wait
  $ cmp copy.ppm ../floor.ppm

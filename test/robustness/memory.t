Memory: three bytes a pixel and a constant. The constant is 12 MB; here it may
be twice as much.

  $ unset DISPLAY
  $ cat > sky.scene <<EOF
  > imWidth 2   imHeight 2   canvWidth 2   canvHeight 2   depth 1
  > bcolor 0.2 0.4 0.6
  > EOF
  $ raylab render sky.scene -j 1 -q --size 5000x4000 -o sky.ppm & pid=$!
  $ peak=0; while now=$(awk '/VmHWM/ { print $2 }' /proc/$pid/status 2> /dev/null)
  >   test -n "$now"; do peak=$now; sleep 0.02; done; wait $pid; rm sky.ppm
  $ test $peak -gt 58000 && test $peak -lt $((58594 + 24000)) || echo "$peak kB"

Bands are joined piece by piece: these have 30 MB each.

  $ for rows in 0-1999 2000-3999; do
  >   raylab render sky.scene -j 1 -q --size 5000x4000 --rows $rows -o $rows.ppm
  > done
  $ for format in bmp png; do
  >   raylab join 0-1999.ppm 2000-3999.ppm -q -o sky.$format & pid=$!
  >   peak=0; while now=$(awk '/VmHWM/ { print $2 }' /proc/$pid/status 2> /dev/null)
  >     test -n "$now"; do peak=$now; sleep 0.02; done; wait $pid
  >   test $peak -gt 1000 && test $peak -lt 24000 || echo "$format: $peak kB"
  > done
  $ rm sky.bmp sky.png *.ppm

A mesh is in memory once, however often it is placed: a forest of 100 million
triangles takes little more than one of its trees.

  $ awk 'BEGIN { for (k = 0; k < 10000; k++) { a = k * 0.7; h = k / 4000;
  >   for (n = 0; n < 3; n++)
  >     printf "v %.4f %.4f %.4f\n", cos(a) * (3 - h) / 4 + n % 2 / 20, h + n / 20, sin(a) * (3 - h) / 4;
  >   printf "f -1 -2 -3\n" } }' > tree.obj
  $ (sed 's/imWidth 2/imWidth 20/; s/imHeight 2/imHeight 20/' sky.scene
  >   cat <<EOF
  > let tree = mesh "tree.obj" smooth diffusive 0.2 0.5 0.2
  > for i = 1 to 100 for j = 1 to 100 tree translated (2 * i - 100) -1 (2 * j) end end
  > EOF
  > ) > forest.scene
  $ raylab render forest.scene -j 1 -q -o forest.ppm & pid=$!
  $ peak=0; while now=$(awk '/VmHWM/ { print $2 }' /proc/$pid/status 2> /dev/null)
  >   test -n "$now"; do peak=$now; sleep 0.02; done; wait $pid
  $ test $peak -gt 12000 && test $peak -lt 64000 || echo "$peak kB"
  $ rm tree.obj forest.*

What does not fit ends with one line. No file is there, new or half.

  $ (ulimit -v 1500000; raylab render sky.scene -q -j 2 --size 30000x30000)
  raylab: out of memory
  [125]
  $ ls -A
  sky.scene

A scene that is too large is refused before there is room made for it.

  $ truncate -s 2G huge.scene
  $ (ulimit -v 1500000; raylab check huge.scene)
  huge.scene: error: the scene is larger than 2147483647 bytes
  [1]
  $ rm huge.scene

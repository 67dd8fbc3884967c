A picture in eight bands on a real Slurm of two nodes, which ends as the picture
that is rendered at once, byte for byte.

  $ . ./cluster.sh
  $ start_cluster
  $ cat > picture.scene <<END
  > imWidth 60   imHeight 43   canvWidth 6   canvHeight 4.3  depth 4
  > bcolor 0.2 0.3 0.5
  > lights
  > directional 0.9 1 0.9 0.8  1 -2 1.5
  > objects
  > plane 0 -1.5 0  0 1 0  diffusive 0.8 0.3 0.2
  > sphere 0 0 4 1.4       mixed 0.2 diffusive red 0.8 reflective
  > END
  $ for format in bmp png ppm; do raylab render picture.scene -q -o whole.$format; done

What the tasks run is not raylab but this, which writes down what it is asked to
render. It fails or hangs if there is a file that says so.

  $ cat > "$top/raylab" <<END
  > #!/bin/sh
  > cd "\$PWD" || exit
  > if [ "\$1" = render ]; then
  >   rows=\$(echo "\$*" | sed 's/.*--rows \([^ ]*\).*/\1/')
  >   echo "\$rows" >> $top/rendered
  >   if mv $top/fails-\$rows $top/failed 2> /dev/null; then exit 2; fi
  >   if [ -e $top/hangs-\$SLURMD_NODENAME ]; then touch $top/hanging; sleep 1000; fi
  > fi
  > exec $(command -v raylab) "\$@"
  > END
  $ chmod +x "$top/raylab"
  $ export RAYLAB=$top/raylab
  $ rendered () { sort -n $top/rendered | uniq -c | sed 's/^ *//'; rm $top/rendered; }

Eight bands and the join
------------------------

  $ slurm () { raylab slurm picture.scene --bands 8 --submit "$@" | sed 's/job [0-9]*/job N/'; }
  $ slurm -o a.bmp
  job N renders bands 1-8
  job N joins them
  $ over
  $ cmp a.bmp whole.bmp
  $ rendered
  1 0-4
  1 5-9
  1 10-15
  1 16-20
  1 21-25
  1 26-31
  1 32-36
  1 37-42

Paths may have any characters.

  $ mkdir "it's a \"dir\""
  $ slurm -o "it's a \"dir\"/my \$picture.png" -j 2
  job N renders bands 1-8
  job N joins them
  $ over
  $ cmp it*/*.png whole.png
  $ rendered | wc -l
  8

A band that fails once
----------------------

  $ touch $top/fails-10-15
  $ slurm -o b.ppm
  job N renders bands 1-8
  job N joins them
  $ over
  $ cmp b.ppm whole.ppm
  $ rendered
  1 0-4
  1 5-9
  2 10-15
  1 16-20
  1 21-25
  1 26-31
  1 32-36
  1 37-42
  $ cat b.slurm/log/band-3.txt
  rows 10-15, try 1: exit status 2

Submitted again
---------------

One that fails three times is missing, and the join says so. When the job is
submitted again only that band is rendered.

  $ cat > $top/broken <<END
  > #!/bin/sh
  > case "\$*" in *10-15*) exit 2;; esac
  > exec $top/raylab "\$@"
  > END
  $ chmod +x $top/broken
  $ RAYLAB=$top/broken slurm -o c.bmp
  job N renders bands 1-8
  job N joins them
  $ over
  $ ls c.bmp c.slurm/bands
  ls: cannot access 'c.bmp': No such file or directory
  c.slurm/bands:
  1.ppm
  2.ppm
  4.ppm
  5.ppm
  6.ppm
  7.ppm
  8.ppm
  [2]
  $ cat c.slurm/log/join.txt
  raylab: rows 10-15 are missing
  $ rm $top/rendered
  $ slurm -o c.bmp
  job N renders bands 3
  job N joins them
  $ over
  $ cmp c.bmp whole.bmp
  $ rendered
  1 10-15

When all bands are there, only the join is submitted.

  $ rm c.bmp
  $ c.slurm/submit | sed 's/job [0-9]*/job N/'
  job N joins them
  $ over
  $ cmp c.bmp whole.bmp

A node that is lost
-------------------

Tasks hang on node 2 when it goes away. Slurm runs them again.

  $ touch $top/hangs-n2
  $ slurm -o d.bmp
  job N renders bands 1-8
  job N joins them
  $ until_ok test -e $top/hanging
  $ kill -9 $(cat $top/n2.pid)
  $ scontrol update nodename=n2 state=down reason=lost
  $ over
  $ cmp d.bmp whole.bmp
  $ rendered | grep -q "^2 "

More bands than this Slurm takes
--------------------------------

  $ raylab slurm picture.scene -o e.ppm --size 3x1500 --bands 1500 --submit
  raylab: warning: --size 3x1500 distorts the picture, which looks 698 times as high as it should; 3x2 would not
  This cluster takes at most 1000 bands (its MaxArraySize is 1001), not 1500. Remove $TESTCASE_ROOT/e.slurm and make the job with fewer.
  raylab: $TESTCASE_ROOT/e.slurm/submit has failed; it may be run again
  [2]

Bands: parts of a picture that know where they belong, and "raylab join", which
makes the picture of them.

  $ unset DISPLAY
  $ cat > mirror.scene <<EOF
  > imWidth 60   imHeight 40   canvWidth 6   canvHeight 4   depth 4
  > bcolor 0.2 0.3 0.5
  > lights
  > directional 0.9 1 0.9 0.8  1 -2 1.5
  > objects
  > plane 0 -1.5 0  0 1 0      diffusive 0.8 0.3 0.2
  > sphere 0 0 4 1.4           mixed 0.2 diffusive red 0.8 reflective
  > EOF
  $ band () { raylab render mirror.scene -q --rows "$@"; }
  $ for format in bmp png ppm; do
  >   raylab render mirror.scene -q -o whole.$format
  >   band 0-12 -o a.$format; band 13-13 -o b.$format; band 14-39 -o c.$format
  > done

In any order, from any format to any.

  $ for format in bmp png ppm; do
  >   raylab join c.$format a.$format b.$format -o joined.$format
  >   cmp joined.$format whole.$format
  > done
  raylab: wrote joined.bmp
  raylab: wrote joined.png
  raylab: wrote joined.ppm
  $ raylab join b.png a.ppm c.bmp -q -o joined
  $ cmp joined whole.bmp
  $ raylab join b.png a.ppm c.bmp -o - | cmp - whole.bmp
  $ raylab join b.png a.ppm c.bmp -o - --format png | cmp - whole.png

A folder is the files in it, but for those that are being written.

  $ mkdir -p bands/empty
  $ cp a.ppm b.ppm bands
  $ head -c 20 c.ppm > bands/.raylab-1.part
  $ raylab join bands c.bmp -q -o joined
  raylab: bands/empty: Is a directory
  [1]
  $ raylab join bands/empty -q -o joined
  raylab: there are no bands to join
  [1]
  $ rmdir bands/empty
  $ raylab join bands c.bmp -q -o joined
  $ cmp joined whole.bmp
  $ raylab join bands c.bmp -q -o bands/b.ppm
  raylab: bands/b.ppm is one of the bands; the picture would replace it
  [124]

Bands that overlap are joined if they agree. One that is the whole picture is it.

  $ band 10-20 -o d.png
  $ raylab join d.png a.ppm c.bmp c.bmp -q -o joined.ppm
  $ cmp joined.ppm whole.ppm
  $ band 0-39 -o all.ppm
  $ raylab join all.ppm -q -o joined.ppm
  $ cmp joined.ppm whole.ppm

Options that change the picture must be the same for all bands.

  $ raylab render mirror.scene -q --grey --size 30x20 -o small.png
  $ band 0-9 --grey --size 30x20 -o - > small0
  $ band 10-19 --grey --size 30x20 -j 1 -o small1.ppm
  $ raylab join small1.ppm small0 -q -o joined.png
  $ cmp joined.png small.png

The label
---------

It is text, and the same in every format.

  $ for format in bmp png ppm; do grep -a -o 'raylab-band.* crc32 ........' a.$format; done
  raylab-band 2 rows 0-12 of 60x40 rgb samples 1 exposure 1 linear scene fb769256cfaf860a134948ef0f073879 raylab 0.1.0 crc32 2813a98d
  raylab-band 2 rows 0-12 of 60x40 rgb samples 1 exposure 1 linear scene fb769256cfaf860a134948ef0f073879 raylab 0.1.0 crc32 2813a98d
  raylab-band 2 rows 0-12 of 60x40 rgb samples 1 exposure 1 linear scene fb769256cfaf860a134948ef0f073879 raylab 0.1.0 crc32 2813a98d

Refused
-------

What is wrong is named, and an older picture stays.

  $ echo older > old.bmp
  $ join () { raylab join "$@" -o old.bmp; }

Rows are missing:

  $ join b.ppm
  raylab: rows 0-12 are missing
  raylab: rows 14-39 are missing
  [1]
  $ join a.ppm c.ppm
  raylab: row 13 is missing
  [1]

Bands of something else:

  $ sed 's/1.4/1.5/' mirror.scene > other.scene
  $ raylab render other.scene -q --rows 13-13 -o other.ppm
  $ join a.ppm other.ppm c.ppm
  raylab: a.ppm and other.ppm are not of one picture: the scenes differ
  [1]
  $ join a.ppm small1.ppm b.ppm
  raylab: a.ppm and small1.ppm are not of one picture: the sizes differ, 60x40 and 30x20
  [1]
  $ raylab render mirror.scene --grey -q --rows 13-13 -o grey.ppm
  $ join a.ppm grey.ppm c.ppm
  raylab: a.ppm and grey.ppm are not of one picture: one is grey
  [1]

Files that are damaged, or no bands:

  $ head -c 2000 c.ppm > cut.ppm
  $ { head -c 1000 c.bmp; printf X; tail -c +1002 c.bmp; } > changed.bmp
  $ { head -c 200 c.png; printf X; tail -c +202 c.png; } > changed.png
  $ join a.ppm cut.ppm changed.bmp changed.png b.ppm whole.bmp mirror.scene missing.ppm
  raylab: cut.ppm: the band is damaged: it has 2000 bytes instead of 4828
  raylab: changed.bmp: the band is damaged: its pixels do not have the checksum of its label
  raylab: changed.png: the band is damaged: not all of its parts are there and right
  raylab: whole.bmp: not a band, or its label is damaged: raylab render --rows writes bands
  raylab: mirror.scene: not a band, or its label is damaged: raylab render --rows writes bands
  raylab: missing.ppm: No such file or directory
  [1]
  $ cat old.bmp
  older

Where it goes
-------------

  $ raylab join a.ppm b.ppm c.ppm 2>&1 | head -n 1
  raylab: required option --output is missing
  $ raylab join a.ppm b.ppm c.ppm -o b.ppm
  raylab: b.ppm is one of the bands; the picture would replace it
  [124]
  $ raylab join a.ppm b.ppm c.ppm -o a.gif
  raylab: a.gif: there is no picture format '.gif'; use .bmp, .png or .ppm
  [124]
  $ raylab join a.ppm b.ppm c.ppm -o a.png --format bmp
  raylab: a.png: the extension says another format than --format does; leave one of them out
  [124]
  $ raylab join a.ppm b.ppm c.ppm -o .png
  raylab: .png: there is no name before the extension; put one there
  [124]
  $ raylab join a.ppm b.ppm c.ppm -o ""
  raylab: option -o: the name of the file is empty
  [124]
  $ raylab join a.ppm b.ppm c.ppm -o missing/a.bmp
  raylab: missing/a.bmp: No such file or directory
  [2]
  $ raylab join a.ppm b.ppm c.ppm -o /dev/full
  raylab: /dev/full: No space left on device
  [2]
  $ raylab join a.bmp b.bmp c.bmp -o - > /dev/full
  raylab: standard output: No space left on device
  [2]
  $ raylab join -o a.bmp 2>&1 | head -n 1
  raylab: required argument PART is missing

File names do not control the terminal.

  $ esc=$(printf 'a\033[31m')
  $ echo > "$esc"
  $ raylab join "$esc" -o a.bmp 2>&1 | tr -cd '\033'

A picture may be as wide as one likes, in every format.

  $ for format in bmp png ppm; do
  >   raylab render mirror.scene -q --size 30000x2 -o wide.$format
  >   raylab render mirror.scene -q --size 30000x2 --rows 0-0 -o wide0.$format
  >   raylab render mirror.scene -q --size 30000x2 --rows 1-1 -o wide1.$format
  > done
  $ for format in bmp png ppm; do
  >   raylab join wide0.png wide1.$format -q -o joined.$format
  >   cmp joined.$format wide.$format
  > done

Nothing is left of all this.

  $ ls -A | grep '[.]part$'
  [1]

Pictures that are saved are shown, too, if there is a display.

  $ . ./drive.sh
  $ cat > red.scene <<EOF
  > imWidth 120   imHeight 90   canvWidth 4   canvHeight 3   depth 4
  > sphere 0 0 3 1  luminous red
  > EOF

Without one
-----------

  $ unset DISPLAY
  $ raylab view red.scene
  raylab: no display was found: DISPLAY is not set
  [2]
  $ DISPLAY=:987 raylab view red.scene
  raylab: no display was found: cannot open ':987'
  [2]
  $ DISPLAY=nowhere raylab view red.scene
  raylab: no display was found: cannot open 'nowhere'
  [2]
  $ raylab view red.scene --size 50000x50000
  raylab: a picture of 50000 x 50000 pixels would take 7.0 GiB of memory; the limit is 4 GiB
  [2]
  $ raylab red.scene
  raylab: wrote red.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ raylab red.scene -q
  $ raylab render red.scene --show -o shown.bmp
  raylab: wrote shown.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ cmp red.bmp shown.bmp
  $ raylab render red.scene -o a.bmp
  raylab: wrote a.bmp

With one
--------

  $ start_server 1000x700
  $ picture red.scene > red.rgb
  $ rm *.bmp
  $ start red.scene red.scene
  $ until_ok is_picture red.rgb
  $ cat err
  raylab: wrote red.bmp
  $ press q
  $ ended
  $ start red.scene render red.scene --show -o shown.png
  $ until_ok is_picture red.rgb
  $ ls shown.png
  shown.png
  $ press q
  $ ended

Rows are shown as they are saved, and clicks count from the top of all.

  $ picture red.scene --rows 40-69 > rows.rgb
  $ start red.scene render red.scene --show --rows 40-69 -o rows.ppm
  $ until_ok is_picture rows.rgb
  $ click 60 5
  $ until_ok said 'pixel (60, 45)'
  $ press c
  $ press r
  $ shows '%\| s$'
  $ until_ok is_picture rows.rgb
  $ press q
  $ ended

A picture that goes to standard output is shown only if that is asked for, and
then explained on standard error.

  $ raylab red.scene -o - 2> err | wc -c
  32454
  $ start red.scene render red.scene --show -o -
  $ click 60 45
  $ until_ok told 'pixel (60, 45)'
  $ press q
  $ ended
  $ wc -c < out
  32454

Nobody may be there to read. The window does not get what is printed.

  $ raylab view red.scene >&- 2>&- &
  $ pid=$!
  $ until_ok has_window '^red.scene'
  $ click 60 45
  $ press h
  $ press c
  $ until_ok is_picture red.rgb
  $ press q
  $ ended

The window, driven as by a user.

  $ . ./drive.sh
  $ start_server 1000x700
  $ cat > mirror.scene <<EOF
  > imWidth 120   imHeight 90   canvWidth 4   canvHeight 3   depth 4
  > bcolor 0.2 0.3 0.5
  > lights   spherical 20 white  -1 3 1   directional 0.3 white  0 -1 0
  > objects
  > plane 0 -1 0  0 1 0    diffusive white
  > sphere 0 0 3 1         reflective
  > EOF
  $ picture mirror.scene > mirror.rgb

Fills, and is the picture
-------------------------

  $ start mirror.scene view mirror.scene
  $ whole
  $ title | sed 's/[0-9.]* s$/N s/'
  mirror.scene, 120 x 90: N s
  $ size
  120x90
  $ until_ok is_picture mirror.rgb

Clicks and keys
---------------

A click explains the pixel as raylab explain does, and draws over the picture.

  $ click 60 45
  $ raylab explain mirror.scene 60,45 > explained
  $ until_ok said 'lit'
  $ explains () { head -n $(wc -l < explained) out | diff explained - > /dev/null; }
  $ until_ok explains
  $ until_ok is_not_picture mirror.rgb

e hides the path and shows it, c clears it; another click draws another.

  $ press e
  $ until_ok is_picture mirror.rgb
  $ press e
  $ until_ok is_not_picture mirror.rgb
  $ press c
  $ until_ok is_picture mirror.rgb
  $ press e
  $ click 10 5
  $ until_ok said 'pixel (10, 5)'
  $ until_ok is_not_picture mirror.rgb
  $ press c
  $ until_ok is_picture mirror.rgb

h lists the keys, s saves, and other keys do nothing.

  $ press x
  $ press Return
  $ press Up
  $ press h
  $ until_ok said 'close the window'
  $ press s
  $ until_ok told wrote
  $ cat err
  raylab: wrote mirror.bmp
  $ raylab render mirror.scene -q -o again.bmp && cmp mirror.bmp again.bmp
  $ raylab view mirror.scene -o mirror.scene
  raylab: mirror.scene is the scene; the picture would replace it
  [124]
  $ raylab view mirror.scene -o -
  raylab: option -o: explanations go to standard output
  [124]
  $ raylab view mirror.scene -o mirror.gif
  raylab: mirror.gif: there is no picture format '.gif'; use .bmp, .png or .ppm
  [124]

Keys do the same with Caps Lock.

  $ press Caps_Lock
  $ press s
  $ wrote_twice () { test $(grep -c wrote err) = 2; }
  $ until_ok wrote_twice
  $ press Caps_Lock

A message goes with the next key or click.

  $ press x
  $ until_ok is_picture mirror.rgb

r renders the file again.

  $ sed 's/0.2 0.3 0.5/0.5 0.3 0.2/' mirror.scene > other.scene
  $ picture other.scene > other.rgb
  $ cp mirror.scene first.scene && cp other.scene mirror.scene
  $ press r
  $ until_ok is_picture other.rgb
  $ cp first.scene mirror.scene

The window may be resized: the picture stays in the middle, in whole pixels or
scaled down, and clicks still name the right one.

  $ xdotool windowsize "$window" 250 200
  $ until_ok has_size 250x200
  $ is_doubled () {
  >   contents | convert -size 250x200 -depth 8 rgb:- -crop 240x180+5+10 +repage \
  >     -sample 50% rgb:- 2>/dev/null | cmp -s - other.rgb
  > }
  $ until_ok is_doubled
  $ click 249 190
  $ click 244 189
  $ until_ok said 'pixel (119, 89)'
  $ xdotool windowsize "$window" 60 80
  $ until_ok has_size 60x80
  $ press c
  $ click 0 20
  $ until_ok said 'pixel (1, 7)'

q closes it.

  $ press q
  $ ended
  $ grep -c '^pixel' out
  4
  $ uniq err
  raylab: wrote mirror.bmp

The eye
-------

A drag turns the eye around the point at which it looks; half of the picture is a
quarter of a turn. v prints what the scene needs to show the same.

  $ start mirror.scene view mirror.scene
  $ whole
  $ drag 30 30 50 31 80 32 90 30
  $ press v
  $ until_ok said lookAt
  $ cat out
  eye -4 0 0   lookAt 0 0 0
  $ { cat out; cat mirror.scene; } > turned.scene
  $ picture turned.scene > turned.rgb
  $ press x
  $ until_ok is_picture turned.rgb

So do + and -, and 0 goes back. A click explains what is seen, and is no drag
even if the hand shakes.

  $ press plus; press plus; press minus
  $ press v
  $ nearer () { said '^eye -3.2 0 0   lookAt 0 0 0$'; }
  $ until_ok nearer
  $ press 0
  $ press x
  $ until_ok is_picture mirror.rgb
  $ drag 60 45 62 47
  $ until_ok said 'pixel (60, 45)'
  $ press c
  $ press minus
  $ press s
  $ until_ok told wrote
  $ echo 'eye 0 0 -5' | cat - mirror.scene > farther.scene
  $ raylab render farther.scene -q -o farther.bmp && cmp mirror.bmp farther.bmp
  $ press q
  $ ended
  $ grep wrote err
  raylab: wrote mirror.bmp

Every way of closing
--------------------

  $ start mirror.scene view mirror.scene
  $ press Escape
  $ ended
  $ cat out err

In the middle of a rendering that would take hours:

  $ cat > hall.scene <<EOF
  > imWidth 320   imHeight 240   canvWidth 4   canvHeight 3   depth 4
  > raydepth 100000
  > plane 0 0 9 0 0 1 reflective   plane 0 0 -9 0 0 1 reflective
  > EOF
  $ start hall.scene view hall.scene
  $ shows '320 x 240: [0-9]* %$'
  $ press q
  $ ended
  $ start hall.scene view hall.scene -j 2
  $ shows '%$'

The window manager closes a window by ending its connection:

  $ xdotool windowkill "$window"
  $ ended
  $ start mirror.scene view mirror.scene
  $ whole
  $ xdotool windowkill "$window"
  $ ended
  $ cat out err

Ctrl-C:

  $ start hall.scene view hall.scene
  $ kill -INT $pid
  $ ended
  [130]
  $ start mirror.scene view mirror.scene
  $ whole
  $ kill -INT $pid
  $ ended
  [130]

also when the window's timer goes off at the same moment:

  $ start mirror.scene view mirror.scene
  $ whole
  $ kill -STOP $pid; kill -INT $pid; kill -ALRM $pid; kill -CONT $pid
  $ ended
  [130]
  $ cat out err

The display goes away:

  $ start hall.scene view hall.scene
  $ shows '%$'
  $ kill $server
  $ ended
  $ start_server 1000x700
  $ start mirror.scene view mirror.scene
  $ whole
  $ kill $server
  $ ended
  $ cat out err

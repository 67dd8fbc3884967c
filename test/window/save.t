Whether the key s can save is told when it is pressed, not when the picture is
whole: this one, of two mirrors that face each other, would take hours.

  $ . ./drive.sh
  $ start_server 400x300
  $ mkdir dir
  $ cat > dir/hall.scene <<EOF
  > imWidth 200   imHeight 100   canvWidth 4   canvHeight 3   depth 4
  > raydepth 1000000
  > plane 0 0 9 0 0 1 reflective   plane 0 0 -9 0 0 1 reflective
  > EOF
  $ start hall.scene view dir/hall.scene
  $ press s
  $ until_ok told 'will be saved'
  $ rm -r dir
  $ press s
  $ until_ok told 'dir/hall.bmp: No such file or directory'
  $ press q
  $ ended

A scene from a pipe is read once, and has no name to call its picture after,
whatever the pipe is called.

  $ echo 'imWidth 40 imHeight 30 canvWidth 4 canvHeight 3 depth 4' > sky.scene
  $ start 'standard input' view /dev/stdin < sky.scene
  $ whole
  $ press r
  $ press s
  $ until_ok told 'standard input has no name'
  $ press q
  $ ended
  $ cat err
  /dev/stdin: warning: there is no object: the picture is all background
  raylab: a scene from standard input has no name to call its picture after: say where it goes with -o

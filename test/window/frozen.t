A display that accepts whoever comes and then says nothing. A signal ends raylab
all the same, though it waits in the X library, where no handler would run.

  $ . ./drive.sh
  $ cat > red.scene <<END
  > imWidth 120   imHeight 90   canvWidth 4   canvHeight 3   depth 4
  > sphere 0 0 3 1  luminous red
  > END
  $ start_server 400x300

While the window opens
----------------------

raylab itself asks for the screen's size first, and for some seconds only. With a
blank in its name the display is one that only the X library knows, whose socket
is then the first.

  $ has_socket () { ls -l /proc/$pid/fd 2>/dev/null | grep -q 'socket:'; }
  $ silent=": ${DISPLAY#:}"
  $ kill -STOP $server
  $ for signal in INT TERM HUP; do
  >   DISPLAY=$silent run view red.scene
  >   until_ok has_socket
  >   kill -$signal $pid
  >   ended
  > done
  [130]
  [143]
  [129]
  $ DISPLAY=$silent run red.scene
  $ until_ok told wrote
  $ until_ok has_socket
  $ kill -INT $pid
  $ ended
  [130]
  $ kill -CONT $server

In an open window
-----------------

raylab hangs once its main thread takes no turn any more: in a window that
answers it takes ten a second. (Were it seen to hang too early, this would test
less, but not fail.)

  $ turns () { grep -hs ctxt /proc/$pid/task/$pid/status; }
  $ hangs () { before=$(turns); sleep 0.3; test "$before" = "$(turns)"; }
  $ for signal in INT TERM HUP; do
  >   start red.scene view red.scene
  >   whole
  >   kill -STOP $server
  >   until_ok hangs
  >   kill -$signal $pid
  >   ended
  >   kill -CONT $server
  > done
  [130]
  [143]
  [129]
  $ start red.scene view red.scene
  $ press q
  $ ended
  $ cat out err

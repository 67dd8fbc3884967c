"show ()" at the prompt opens the window; once that is closed the prompt goes on.

  $ . ./drive.sh
  $ start_server 1000x700
  $ cat > red.scene <<EOF
  > imWidth 120   imHeight 90   canvWidth 4   canvHeight 3   depth 4
  > sphere 0 0 3 1  luminous red
  > EOF
  $ sed 's/red/green/' red.scene > green.scene
  $ picture red.scene > red.rgb
  $ picture green.scene > green.rgb
  $ cat > twice.ml <<EOF
  > show ();;
  > print_endline "closed once";;
  > load "green.scene";;
  > show ();;
  > print_endline "closed twice";;
  > use (Scene.with_ray_depth 3 (scene ()));;
  > show ();;
  > print_endline "closed thrice";;
  > use (Scene.without_places (scene ()));;
  > show ();;
  > EOF

The window is that of the native program.

  $ start red.scene repl red.scene twice.ml
  $ until_ok is_picture red.rgb
  $ click 60 45
  $ until_ok said 'red sphere (object 1, line 2)'
  $ press q
  $ until_ok said 'closed once'
  $ until_ok has_window '^green.scene'
  $ until_ok is_picture green.rgb
  $ whole
  $ press s
  $ until_ok test -s green.bmp
  $ xdotool windowkill "$window"

What is made of values shows where its objects come from, as far as that is known.

  $ until_ok said 'closed twice'
  $ until_ok has_window '^scene'
  $ until_ok is_picture green.rgb
  $ click 60 45
  $ until_ok said 'green sphere (object 1, line 2)'
  $ press q
  $ until_ok said 'closed thrice'
  $ until_ok has_window '^scene'
  $ until_ok is_picture green.rgb
  $ click 60 45
  $ until_ok said 'green sphere (object 1)'
  $ press c
  $ whole
  $ press s
  $ until_ok test -s scene.bmp
  $ press q
  $ ended
  $ cat err
  raylab: wrote green.bmp
  raylab: wrote scene.bmp
  $ cmp green.bmp scene.bmp

If there is none it is the prompt's own.

  $ { echo 'Unix.putenv "RAYLAB_PROGRAM" "/missing";;'; cat twice.ml; } > here.ml
  $ rm *.bmp
  $ start red.scene repl red.scene here.ml
  $ until_ok is_picture red.rgb
  $ click 60 45
  $ until_ok said 'pixel (60, 45)'
  $ press q
  $ until_ok said 'closed once'
  $ until_ok has_window '^green.scene'
  $ until_ok is_picture green.rgb
  $ press q
  $ until_ok said 'closed twice'
  $ until_ok has_window '^scene'
  $ until_ok is_picture green.rgb
  $ press q
  $ until_ok said 'closed thrice'
  $ until_ok has_window '^scene'
  $ until_ok is_picture green.rgb
  $ whole
  $ press s
  $ until_ok test -s scene.bmp
  $ press q
  $ ended
  $ cat err
  wrote scene.bmp

A terminal is as it was before.

  $ export TMUX_TMPDIR=$(mktemp -d /tmp/raylab-XXXXXX)
  $ tmux () { command tmux -L raylab -f /dev/null "$@"; }
  $ trap 'tmux kill-server 2> /dev/null; rm -rf "$TMUX_TMPDIR"; kill $pid $server 2>/dev/null' EXIT
  $ screen () { tmux capture-pane -p; }
  $ has_prompts () { test "$(screen | grep -c '^raylab #')" -ge "$1"; }
  $ type () { tmux send-keys -l "$1;\;"; tmux send-keys Enter; }
  $ tmux new-session -d -x 80 -y 99 "env -u XDG_STATE_HOME -u XDG_CONFIG_HOME \
  >   HOME='$PWD' '$(command -v raylab)' repl red.scene; exec cat"
  $ until_ok has_prompts 1
  $ for prompts in 2 3; do
  >   type 'show ()'
  >   until_ok has_window '^red.scene'
  >   until_ok is_picture red.rgb
  >   press Escape
  >   until_ok has_prompts $prompts
  > done
  $ type '6 * 7'
  $ until_ok has_prompts 4
  $ screen | sed -n '/^raylab #/,$ { /^[┌│└]/d; /./p }'
  raylab # show ();;
  - : unit = ()
  raylab # show ();;
  - : unit = ()
  raylab # 6 * 7;;
  - : int = 42
  raylab #

Without a display it says so, and the prompt goes on.

  $ unset DISPLAY
  $ raylab repl red.scene twice.ml
  raylab: no display was found: DISPLAY is not set
  closed once
  green.scene: 1 object, 0 lights, 120 x 90 pixels
  raylab: no display was found: DISPLAY is not set
  closed twice
  raylab: no display was found: DISPLAY is not set
  closed thrice
  raylab: no display was found: DISPLAY is not set
  $ raylab repl red.scene here.ml
  no display was found: DISPLAY is not set
  closed once
  green.scene: 1 object, 0 lights, 120 x 90 pixels
  no display was found: DISPLAY is not set
  closed twice
  no display was found: DISPLAY is not set
  closed thrice
  no display was found: DISPLAY is not set

"raylab repl" at a terminal, which tmux pretends to be.

  $ cat > three.scene <<EOF
  > imWidth 5   imHeight 5   canvWidth 4   canvHeight 4   depth 4
  > lights directional 1 white 0 0 1
  > plane 0 -3 0  0 1 0  reflective
  > plane 0 0 20  0 0 1  luminous 1 0.5 0
  > sphere 0 0 2  1      diffusive white
  > EOF
  $ sed 's/diffusive/difuse/' three.scene > broken.scene

A server of our own for each session, since one that is ending refuses another,
and a home of our own. No server survives the test.

  $ mkdir home
  $ export TMUX_TMPDIR=$(mktemp -d /tmp/raylab-XXXXXX)
  $ session=0
  $ tmux () { command tmux -L raylab-$session -f /dev/null "$@"; }
  $ trap 'tmux kill-server 2> /dev/null; rm -rf "$TMUX_TMPDIR"' EXIT
  $ start () {
  >   session=$((session + 1))
  >   tmux new-session -d -x 80 -y 99 \
  >     "env -u XDG_STATE_HOME -u XDG_CONFIG_HOME -u NO_COLOR HOME='$PWD/home' \
  >       '$(command -v raylab)' repl $1; exec cat"
  > }
  $ screen () { tmux capture-pane -p "$@"; }

[wait_until TEST] waits until TEST holds, and at most a minute. Once it has
waited in vain there is no use in waiting again.

  $ wait_until () {
  >   for _ in $(test -e vain || seq 600); do
  >     if "$@"; then return; fi
  >     sleep 0.1
  >   done
  >   echo "in vain: $*"; test -e vain || screen | tee vain; return 1
  > }
  $ shows () { screen | grep -qF -- "$1"; }
  $ has_prompts () { test "$(screen | grep -c '^raylab #')" -ge "$1"; }

[ask PHRASE] types it and waits for the next prompt. tmux would take a last
semicolon for its own.

  $ type () { tmux send-keys -l "${1%;}\;"; tmux send-keys Enter; }
  $ prompts=1
  $ ask () {
  >   wait_until has_prompts $prompts
  >   type "$1"
  >   prompts=$((prompts + 1)); wait_until has_prompts $prompts
  > }

The scene is there, and so is the library. What is left out here is the line
below the prompt, with the words by which it can be completed.

  $ start three.scene
  $ ask 'vec 1. 2.5 (-3.);;'
  $ ask 'primary 2 2;;'
  $ ask 'hit (primary 2 2);;'
  $ ask 'rgb 1. 0.5 0.;;'
  $ ask 'steps (primary 2 2);;'
  $ ask 'next ();;'
  $ ask 'next ();;'
  $ ask 'why 2 2;;'
  $ screen | sed -n '/^three.scene/,$ { /^[┌│└]/d; /./p }'
  three.scene: 3 objects, 1 light, 5 x 5 pixels
  help () lists what raylab knows; Ctrl-D leaves.
  raylab # vec 1. 2.5 (-3.);;
  - : Vec3.t = (1, 2.5, -3)
  raylab # primary 2 2;;
  - : Ray.t = (0, 0, -4) + t (0, 0, 1)
  raylab # hit (primary 2 2);;
  - : Hit.t option = Some object 3, t = 5 at (0, 0, 1), normal (0, 0, -1)
  raylab # rgb 1. 0.5 0.;;
  - : Color.t = rgb 1 0.5 0
  raylab # steps (primary 2 2);;
  - : Event.t Seq.t = 6 steps
  raylab # next ();;
  - : Event.t = cast: (0, 0, -4) + t (0, 0, 1), 4 left in the chain
  raylab # next ();;
  - : Event.t = nearest hit: object 3, t = 5 at (0, 0, 1), normal (0, 0, -1)
  raylab # why 2 2;;
  pixel (2, 2) is rgb 255 255 255:    a white sphere (object 3, line 5), lit by
  light 1
  - : unit = ()
  raylab #

A colour has a patch of that colour.

  $ screen -e | grep -a 'Color.t' | grep -c '48;5;'
  1

A long rendering shows how far it is, and can be interrupted. The prompt goes on.

  $ ask 'let mirror z = plane (vec 0. 0. z) (vec 0. 0. 1.) reflective;;'
  $ ask 'let hall = [ mirror 9.; mirror (-9.) ];;'
  $ ask 'use (Scene.make camera ~ray_depth:20000 ~objects:hall);;'
  $ type 'render ();;'
  $ wait_until shows ' %, '
  $ tmux send-keys C-c
  $ prompts=$((prompts + 1))
  $ ask '6 * 7;;'
  $ screen | grep -A 9 'render' | sed 's/^.*\^C//; /^[┌│└]/d; /./!d'
  raylab # render ();;
  Interrupted.
  raylab # 6 * 7;;
  - : int = 42
  raylab #

Ctrl-D leaves, and what was typed is remembered.

  $ history=home/.local/state/raylab/history
  $ tmux send-keys C-d
  $ wait_until test -s $history
  $ grep -c 'primary 2 2' $history
  3
  $ find home -type f
  home/.local/state/raylab/history
  $ tmux kill-server

A scene in error is reported, and the prompt comes up all the same. It knows what
was typed the last time.

  $ start broken.scene
  $ wait_until has_prompts 1
  $ screen | sed -n '/^broken.scene/,/^raylab/p'
  broken.scene:5:22-27: error: unknown surface 'difuse'
      5 | sphere 0 0 2  1      difuse white
        |                      ^^^^^^
  expected a surface: diffusive, reflective, luminous, glossy, refractive,
  glass, mixed, checker or varying. Did you mean 'diffusive'?
  help () lists what raylab knows; Ctrl-D leaves.
  raylab #
  $ tmux send-keys Up Up Enter
  $ wait_until has_prompts 2
  $ screen | sed -n '/^raylab #/,$ { /^[┌│└]/d; /./p }'
  raylab # render ();;
  - : Picture.t = picture of 640 x 480 pixels
  raylab #
  $ tmux kill-server

The prompt ends with its terminal.

  $ start three.scene
  $ wait_until has_prompts 1
  $ type 'Unix.getpid ();;'
  $ wait_until has_prompts 2
  $ prompt=$(screen | sed -n 's/^- : int = //p')
  $ tmux kill-server
  $ is_gone () { ! kill -0 $prompt 2> /dev/null; }
  $ wait_until is_gone

A terminal that obeys no escape codes gets none: "script" is one here, to which the
phrases are typed.

  $ { echo '6 *'; echo '7;;'; echo 'rgb 1. 0.5 0.;;'; } |
  >   TERM=dumb script -q -e -c 'raylab repl three.scene' typescript > /dev/null
  $ grep -c "$(printf '\033')" typescript
  0
  [1]
  $ tr -d '\r' < typescript | grep -o -e '- :.*' -e '.*scene:.*' -e 'help.*' -e 'raylab #'
  three.scene: 3 objects, 1 light, 5 x 5 pixels
  help () lists what raylab knows; Ctrl-D leaves.
  raylab #
  - : int = 42
  raylab #
  - : Color.t = rgb 1 0.5 0
  raylab #

Ctrl-C where nobody types ends what is under way, then raylab, and so a loop of the
shell.

  $ cat > forever.ml <<EOF
  > let () = Fun.protect (fun () -> print_endline "begun"; while true do () done)
  >   ~finally:(fun () -> print_endline "cleaned up")
  > EOF
  $ cat > loop.bash <<'EOF'
  > for try in 1 2; do eval "raylab repl $1"; echo 'the loop goes on'; done
  > EOF
A busy machine may lose the first.

  $ press_until_gone () {
  >   for _ in $(seq 60); do
  >     printf '\003'
  >     for _ in $(seq 50); do
  >       if grep -q 'Interrupted' typescript; then return; fi
  >       sleep 0.1
  >     done
  >   done
  > }
  $ loop () {
  >   rm -f typescript
  >   { wait_until grep -q 'begun' typescript; press_until_gone; } 2> /dev/null |
  >     env --default-signal=INT \
  >     script -q -f -e -c "bash loop.bash '$1'" typescript > /dev/null
  >   echo "[$?]"
  >   tr -d '\r' < typescript | sed '/^Script/d; s/.*\^C//; /./!d'
  > }
  $ loop forever.ml
  [130]
  begun
  cleaned up
  Interrupted.
  $ loop '< forever.ml'
  [130]
  begun
  cleaned up
  Interrupted.

Any utop
--------

In another utop the words and printers come with Prelude.

  $ session=$((session + 1))
  $ tmux new-session -d -x 80 -y 99 \
  >   "env -u XDG_CONFIG_HOME NO_COLOR=1 HOME='$PWD/home' \
  >     utop -require raylab.toplevel; exec cat"
  $ wait_until shows 'utop #'
  $ type 'open Raylab_toplevel.Prelude;;'
  $ wait_until shows 'command 1'
  $ type 'primary 2 2, red, steps (primary 2 2), scene ();;'
  $ wait_until shows 'command 2'
  $ screen | sed -n '/^utop # primary/,/^─/p' | sed '$d'
  utop # primary 2 2, red, steps (primary 2 2), scene ();;
  - : Ray.t * Color.t * Event.t Seq.t * Scene.t =
  ((0, 0, -4) + t (-0.42172, 0.31546, 0.850081), rgb 1 0 0, 3 steps,
   scene of 640 x 480 pixels, canvas 4 x 3, depth 4
   background rgb 0 0 0, ray depth 4)

How far the rendering is, on a terminal and nowhere else. "script" is a terminal
here. The picture takes longer than the tenth of a second after which the first
line comes.

  $ cat > hall.scene <<EOF
  > imWidth 800   imHeight 600   canvWidth 4   canvHeight 3   depth 3
  > raydepth 8
  > lights
  > spherical 20 white  0 2 3
  > plane 0 -2 0  0 1 0   mixed 0.5 diffusive red   0.5 reflective
  > plane 0 4 0   0 1 0   mixed 0.5 diffusive green 0.5 reflective
  > EOF
  $ terminal () { script -q -e -c "$*" typescript < /dev/null > /dev/null; }

Each line starts over at the left, with blanks over what stood there.

  $ progress () {
  >   tr '\r' '\n' < typescript |
  >     sed -E 's/[0-9]+ (s|min|h)( [0-9]+ (s|min))? left *$/TIME left/
  >             s/ +[0-9]+ %/ N %/' |
  >     grep -a 'rendering' | sort -u
  > }

  $ terminal raylab render hall.scene -j 1
  $ progress
  rendering N %, TIME left

That is for every terminal: there are no escape codes.

  $ grep -c "$(printf '\033')" typescript
  0
  [1]

It is gone at the end: what stays is where the picture went.

  $ tr -d '\r' < typescript | grep -a -o 'raylab: wrote.*'
  raylab: wrote hall.bmp

A picture for standard output has no progress in it.

  $ terminal 'raylab render hall.scene -j 1 -o - > out.bmp'
  $ progress
  rendering N %, TIME left
  $ cmp hall.bmp out.bmp

With -q there is none at all, nor where standard error is not the terminal.

  $ terminal raylab render hall.scene -j 1 -q -o quiet.bmp
  $ progress
  $ terminal 'raylab render hall.scene -j 1 -o not.bmp 2> err'
  $ progress
  $ cat err
  raylab: wrote not.bmp

Ctrl-C ends the line, and the program dies of the signal itself, so that a loop of
the shell ends with it. Here it is typed once there is progress.

  $ cat > slow.scene <<EOF
  > imWidth 800   imHeight 600   canvWidth 4   canvHeight 3   depth 4
  > raydepth 3000
  > plane 0 0 9 0 0 1 reflective   plane 0 0 -9 0 0 1 reflective
  > EOF
  $ cat > loop.bash <<'EOF'
  > for try in 1 2 3; do
  >   raylab render slow.scene
  >   echo "the loop goes on after $?"
  > done
  > EOF
  $ rm typescript
  $ type_ctrl_c () {
  >   for try in $(seq 600); do
  >     grep -q 'left' typescript 2> /dev/null && break; sleep 0.05
  >   done
  >   printf '\003'
  > }
  $ type_ctrl_c | env --default-signal=INT \
  >   script -q -f -e -c 'bash loop.bash' typescript > /dev/null
  [130]
  $ grep -c 'the loop' typescript
  0
  [1]
  $ sed '1,/left/d' typescript | sed 's/ on .*//'
  
  Script done

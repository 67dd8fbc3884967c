An explanation on a terminal has patches of colour. "script" is a terminal here.

  $ cat > sky.scene <<END
  > imWidth 1   imHeight 1   canvWidth 1   canvHeight 1   depth 4
  > bcolor 1 0.5 0
  > END
  $ unset NO_COLOR COLORTERM
  $ export TERM=xterm-256color
  $ terminal () {
  >   script -q -e -c "$*" typescript < /dev/null > /dev/null
  >   sed '/^Script/d' typescript | tr -d '\r' | grep -a -o 'pixel.*' | tr '\033' '^'
  > }

  $ terminal raylab explain sky.scene 0,0
  pixel (0, 0) is rgb 255 128 0: ^[48;5;208m  ^[0m the orange background, since the ray hits
  $ terminal COLORTERM=truecolor raylab explain sky.scene 0,0
  pixel (0, 0) is rgb 255 128 0: ^[48;2;255;128;0m  ^[0m the orange background, since the ray hits

None if the terminal cannot show them, or nobody wants them.

  $ terminal TERM=dumb raylab explain sky.scene 0,0
  pixel (0, 0) is rgb 255 128 0: the orange background, since the ray hits
  $ terminal NO_COLOR=1 raylab explain sky.scene 0,0
  pixel (0, 0) is rgb 255 128 0: the orange background, since the ray hits
  $ terminal NO_COLOR= raylab explain sky.scene 0,0
  pixel (0, 0) is rgb 255 128 0: ^[48;5;208m  ^[0m the orange background, since the ray hits

None in a pipe, and none in JSON, steps and SVG.

  $ terminal 'raylab explain sky.scene 0,0 | cat'
  pixel (0, 0) is rgb 255 128 0: the orange background, since the ray hits
  $ terminal raylab explain sky.scene 0,0 --json --svg path.svg > /dev/null
  $ tr -d '\r' < typescript | LC_ALL=C grep -c '[^ -~]'
  0
  [1]
  $ LC_ALL=C grep -c '[^ -~]' path.svg
  0
  [1]

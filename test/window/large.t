A picture that is larger than the screen.

  $ . ./drive.sh
  $ start_server 400x300
  $ cat > large.scene <<EOF
  > imWidth 1000   imHeight 500   canvWidth 4   canvHeight 2   depth 4
  > bcolor 0.2 0.3 0.5
  > sphere 0 0 3 1  luminous red
  > EOF
  $ start 'standard input' view - -o saved.png < large.scene
  $ whole
  $ size
  360x180

Its proportions stay, every pixel is the mean of those that it shows, and clicks
name the right one of these.

  $ colors () { import -window "$window" -depth 8 -crop $1 txt:- | grep -o '#[0-9A-F]\{6\}' | uniq; }
  $ is_there () { [ "$(colors 1x1+180+90)" = '#FF0000' ]; }
  $ until_ok is_there
  $ colors 1x1+0+0
  #334C80
  $ colors 1x1+359+179
  #334C80
  $ click 359 179
  $ until_ok said 'pixel (998, 498)'
  $ click 0 0
  $ until_ok said 'pixel (1, 1)'

It is saved in full.

  $ press s
  $ until_ok told wrote
  $ press q
  $ ended
  $ cat err
  raylab: wrote saved.png
  $ raylab render large.scene -q -o large.png && cmp saved.png large.png

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

One that is larger still, here of 1.2 GB, of two mirrors that face each other and
take hours: its memory is touched only where there are pixels, so that the first
of them need not wait.

  $ cat > hall.scene <<EOF
  > imWidth 20000   imHeight 20000   canvWidth 4   canvHeight 4   depth 4
  > raydepth 100000
  > plane 0 0 9 0 0 1 reflective   plane 0 0 -9 0 0 1 reflective
  > EOF
  $ start hall.scene view hall.scene
  $ shows ': 0 %$'
  $ kilobytes=$(awk '/VmRSS/ { print $2 }' /proc/$pid/status)
  $ test $kilobytes -lt 300000 || echo "$kilobytes kB"
  $ press q
  $ ended

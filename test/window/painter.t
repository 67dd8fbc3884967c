Every mark that a drawing may have is seen in the window; paint.ml has one of each.

  $ . ./drive.sh
  $ start_server 1000x700
  $ ./paint.exe &
  $ pid=$!
  $ until_ok has_window '^paint'
  $ is_painted () { contents > shot && [ "$(colour 15 15)" = 00ff00 ]; }
  $ colour () { tail -c +$((3 * (100 * $2 + $1) + 1)) shot | od -An -tx1 -N3 | tr -d ' '; }
  $ colours () { for place; do echo $place $(colour ${place%,*} ${place#*,}); done; }
  $ until_ok is_painted

A box, a circle and a polygon, each inside and at its edge; and one that lets
through light, which has only an edge.

  $ colours 15,15 5,15 50,15 40,15 80,20 80,24 15,45 5,45
  15,15 00ff00
  5,15 0000ff
  50,15 00ff00
  40,15 0000ff
  80,20 00ff00
  80,24 0000ff
  15,45 ffffff
  5,45 0000ff

A dashed line, between two dashes, and a colour of the scene.

  $ colours 45,45 65,45 75,45 15,75
  45,45 ff0000
  65,45 ffffff
  75,45 ff0000
  15,75 ff8000

Words: from 40 on, below 60; and up to 90, above 90.

  $ ink () { convert -size 100x100 -depth 8 rgb:shot -crop "$1" +repage txt:- | grep -c '#000000'; }
  $ test $(ink 30x15+40+60) -gt 20 && ink 40x15+0+60
  0
  [1]
  $ test $(ink 40x15+50+77) -gt 20 && ink 10x20+90+77
  0
  [1]
  $ press x
  $ ended

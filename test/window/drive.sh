# Drives the real window, on an X server that is there only for the test. Read by
# the cram tests. Nothing waits for a fixed time: [until_ok] polls.

for tool in Xvfb xdotool import convert; do
  command -v $tool >/dev/null || {
    echo "$tool is missing. What the tests need is installed by: bin/setup --test"
    exit 1
  }
done

pid= server=
trap 'kill $pid $server 2>/dev/null' EXIT
trap 'exit 1' HUP INT TERM

# [until_ok COMMAND...] repeats COMMAND until it succeeds, for half a minute. Once
# that was in vain there is no use in waiting again.
until_ok() {
  local tries=0
  until "$@"; do
    tries=$((tries + 1))
    if [ $tries = 600 ] || [ -e vain ]; then
      echo "waited in vain for: $*"
      touch vain
      cat err
      return 1
    fi
    sleep 0.05
  done
}

# [start_server WIDTHxHEIGHT] starts one under a number that is free.
start_server() {
  rm -f display
  Xvfb -displayfd 3 -screen 0 "$1x24" -nolisten tcp -noreset \
    3>display >server.log 2>&1 &
  server=$!
  until_ok test -s display
  export DISPLAY=:$(cat display)
}

title() { xdotool getwindowname "$window" 2>/dev/null; }
has_window() {
  window=$(xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -n 1)
  [ -n "$window" ]
}

# [run COMMAND...] runs raylab beside the test.
run() {
  # the shell would make standard input /dev/null, and have SIGINT ignored
  { env --default-signal=INT,HUP,TERM raylab "$@" >out 2>err <&5 & } 5<&0
  pid=$!
}

# [start NAME COMMAND...] runs raylab until its window has a title with NAME.
start() {
  local name=$1
  shift
  run "$@"
  until_ok has_window "^$name"
}

# [shows PATTERN] waits for a title.
has_title() { title | grep -q "$1"; }
shows() { until_ok has_title "$1"; }
whole() { shows ' s$'; }

# [press KEY], [click X Y]
press() { xdotool mousemove --window "$window" 3 3 key "$1"; }
click() { xdotool mousemove --window "$window" "$1" "$2" click 1; }

# [drag X Y X Y ...] presses the button at the first place, and lets it go at the
# last.
drag() {
  xdotool mousemove --window "$window" "$1" "$2" mousedown 1
  shift 2
  while [ $# -gt 0 ]; do
    xdotool mousemove --window "$window" "$1" "$2"
    shift 2
  done
  xdotool mouseup 1
}

# What the window shows, and what it should: bytes, three a pixel.
contents() { import -window "$window" -depth 8 rgb:- 2>/dev/null; }
pixels_of() { tail -c "$2" "$1"; }
is_picture() { contents | cmp -s - "$1"; }
is_not_picture() { ! is_picture "$1"; }
size() { xdotool getwindowgeometry "$window" | sed -n 's/.*Geometry: //p'; }
has_size() { [ "$(size)" = "$1" ]; }

# [picture SCENE OPTIONS...] is what raylab renders, as such bytes.
picture() {
  raylab render "$@" -q -o picture.ppm &&
    tail -c $((3 * $(grep -a -m 1 '^[0-9]' picture.ppm | tr ' ' '*'))) picture.ppm
}

said() { grep -q -- "$1" out; }
told() { grep -q -- "$1" err; }

# [ended] waits for raylab's end and prints its exit code, if it is not 0.
is_over() { ! kill -0 "$pid" 2>/dev/null; }
ended() {
  until_ok is_over || kill -9 "$pid"
  wait "$pid"
  local code=$?
  [ $code = 0 ] || echo "[$code]"
}

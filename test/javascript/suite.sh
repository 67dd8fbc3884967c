# suite.sh RUNTIME ROOM ARGUMENT...: runs the suite ../ROOM/test_ROOM as
# JavaScript. RUNTIME has what alcotest has in C otherwise.
set -e
runtime=$1 room=$2
shift 2
mkdir -p "$room.logs"
js_of_ocaml --quiet "$runtime" "../$room/test_$room.bc" -o "$room.js" \
  2> "$room.log" || { cat "$room.log" >&2; exit 1; }
cd "../$room"
node "../javascript/$room.js" "$@" --compact -o "../javascript/$room.logs"

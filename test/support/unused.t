No test has a function that nobody uses. The compiler finds them where there is an
interface. Suites have none: all that a suite gives is called suite, and all else
in it is for itself.

  $ unused () {
  >   awk '
  >     /^(let|and) / { defined[$2 == "rec" ? $3 : $2] }
  >     { gsub(/[^A-Za-z0-9_]+/, " "); for (k = 1; k <= NF; k++) count[$k]++ }
  >     END {
  >       delete defined["suite"]
  >       for (name in defined) if (count[name] == 1) print name
  >     }
  >   ' "$1"
  > }
  $ for file in ../*/*.ml; do
  >   [ -e "${file}i" ] || unused "$file" | sed "s|^|$file: |"
  > done

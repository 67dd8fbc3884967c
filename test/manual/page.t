raylab-scene(5) as groff shows it, which man asks, and which has no warning to
give, nor has mandoc. It says what doc/language.md says: every line of code and
every heading.

  $ groff -man -ww -Tutf8 -P-cbou -rLL=80n ../../bin/man/raylab-scene.5 > page
  $ mandoc -T lint ../../bin/man/raylab-scene.5
  $ sed 's/^ *//' page > lines
  $ awk '/^```/ { code = !code; next } code || /^    /' ../../doc/language.md |
  >   sed 's/^ *//; /^$/d' | grep -vxFf lines
  [1]
  $ sed -n 's/^###* //p' ../../doc/language.md | tr -d '`' | grep -vixFf lines
  [1]

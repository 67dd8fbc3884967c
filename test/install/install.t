What is installed is whole, and works where it is put: here, in prefix/.

  $ cp -RL "$(dirname "$(command -v raylab)")/.." prefix
  $ ls prefix prefix/bin
  prefix:
  bin
  doc
  lib
  man
  
  prefix/bin:
  raylab
  raylab-utop
  $ export PATH=$PWD/prefix/bin:$PATH OCAMLPATH=$PWD/prefix/lib
  $ console=$PWD/../manual/console.exe
  $ cp ../../scenes/first.scene .

The manual has a page for every command, and for no other.

  $ raylab --help=plain | sed -n '/^COMMANDS/,/^ARGUMENTS/p' |
  >   sed -n 's/^ \{7\}\([a-z]\+\) .*/raylab-\1.1/p' > pages
  $ echo raylab.1 >> pages
  $ ls prefix/man/man1 | diff - pages

The program says where the language is told: in a page of the manual that every
other one names, and in a folder, with pictures, the gallery and the lesson.

  $ ls prefix/man/man5
  raylab-scene.5
  $ grep -L 'scene.*(5)' prefix/man/man1/*
  $ TERM=dumb raylab help | tr -s ' \n' ' ' |
  >   grep -o 'The language of scenes.*why-black.md'
  The language of scenes has a manual, raylab-scene(5). $TESTCASE_ROOT/prefix/doc/raylab holds it with pictures, doc/language.md, a gallery of scenes, scenes, and a lesson at the prompt, scenes/why-black.md
  $ ls ../../scenes > gallery
  $ ls prefix/doc/raylab/scenes | diff gallery -

All that is there works from there: links, scenes, and the commands of the page.

  $ cd prefix/doc/raylab
  $ find . -name '*.md' | while read -r page; do
  >   { grep -o '](\([^)]*\))' "$page" | tr -d ']()'; sed -n 's/^\[.*\]: //p' "$page"; } |
  >     sed 's/#.*//; /^$/d' | (cd "${page%/*}" && xargs -r ls -d) > /dev/null
  > done
  $ raylab check scenes/*.scene > /dev/null
  $ "$console" doc/language.md doc/language | diff doc/language.md -
  $ cd "$OLDPWD"

The version is the same everywhere, and CHANGES.md knows it, unless it is not
released yet.

  $ version=$(sed -n 's/^(version \(.*\))$/\1/p' ../../dune-project)
  $ test "$(raylab --version)" = "$version"
  $ test "$(ocamlfind query -format %v raylab.tracer)" = "$version"
  $ grep -m 1 '^## ' ../../CHANGES.md | grep -qx "## \(Unreleased\|$version\)"

A project of somebody else's renders with the libraries. The core needs little.

  $ ocamlfind query -recursive -format %p raylab.language raylab.tracer | sort
  menhirLib
  raylab.expression
  raylab.geometry
  raylab.language
  raylab.mesh_file
  raylab.parallel
  raylab.scene
  raylab.source
  raylab.tracer
  $ ocamlfind query -recursive -format %p raylab.language raylab.viewer |
  >   grep -E 'unix|thread|graphics|zip|utop'
  [1]
  $ mkdir other
  $ cat > other/dune-project <<EOF
  > (lang dune 3.17)
  > EOF
  $ cat > other/dune <<EOF
  > (executable
  >  (name other)
  >  (libraries raylab.language raylab.tracer))
  > EOF
  $ cat > other/other.ml <<EOF
  > open Raylab_language
  > open Raylab_tracer
  > 
  > let () =
  >   let scene = Result.get_ok (Scene_file.load Sys.argv.(1)) in
  >   let picture, _ = Render.picture (Prepared.make scene) in
  >   print_bytes (Picture.to_rgb picture)
  > EOF
  $ dune build --root other --no-print-directory ./other.exe
  $ other/_build/default/other.exe first.scene > bytes
  $ raylab render first.scene -q -o first.ppm
  $ tail -c "$(wc -c < bytes)" first.ppm | cmp - bytes

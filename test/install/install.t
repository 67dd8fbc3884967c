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
  $ cp ../../scenes/first.scene .

The manual has a page for every command, and for no other.

  $ raylab --help=plain | sed -n '/^COMMANDS/,/^ARGUMENTS/p' |
  >   sed -n 's/^ \{7\}\([a-z]\+\) .*/raylab-\1.1/p' > pages
  $ echo raylab.1 >> pages
  $ ls prefix/man/man1 | diff - pages

The version is the same everywhere, and CHANGES.md knows it, unless it is not
released yet.

  $ version=$(sed -n 's/^(version \(.*\))$/\1/p' ../../dune-project)
  $ test "$(raylab --version)" = "$version"
  $ test "$(ocamlfind query -format %v raylab.tracer)" = "$version"
  $ grep -m 1 '^## ' ../../CHANGES.md | grep -qx "## \(Unreleased\|$version\)"

A project of somebody else's renders with the libraries. The core needs little.

  $ ocamlfind query -recursive -format %p raylab.language raylab.tracer | sort
  menhirLib
  raylab.geometry
  raylab.language
  raylab.parallel
  raylab.scene
  raylab.tracer
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
  >   let picture, _ = Render.picture (Trace.prepare scene) in
  >   print_bytes (Picture.to_rgb picture)
  > EOF
  $ dune build --root other --no-print-directory ./other.exe
  $ other/_build/default/other.exe first.scene > bytes
  $ raylab render first.scene -q -o first.ppm
  $ tail -c "$(wc -c < bytes)" first.ppm | cmp - bytes

bin/setup on many machines. Each is a file in os/, apt's sources in apt/, and
tools that only pretend. Those in tools/ are everywhere; PATH has nothing else.

  $ mkdir os tools sudo opam
  $ for tool in bash env awk sed sort cat tee rm; do
  >   ln -s "$(command -v $tool)" tools/
  > done
  $ tool () { printf '#!/bin/sh\n%s\n' "$2" > $1; chmod +x $1; }
  $ tool tools/id 'echo $WHO'
  $ tool tools/dpkg-query 'cat installed; exit 1'
  $ tool tools/apt-get 'echo "apt-get: no network" >&2; exit 100'
  $ tool sudo/sudo 'exec "$@"'
  $ tool opam/opam 'cat switch'

  $ os () { printf 'ID=%s\nVERSION_ID="%s"\nPRETTY_NAME="%s"\n' "$2" "$3" "$4" > os/$1; }
  $ os debian12 debian 12 'Debian GNU/Linux 12 (bookworm)'
  $ os debian13 debian 13 'Debian GNU/Linux 13 (trixie)'
  $ os ubuntu24 ubuntu 24.04 'Ubuntu 24.04 LTS'
  $ os ubuntu25 ubuntu 25.04 'Ubuntu 25.04'
  $ os fedora fedora 42 'Fedora Linux 42'
  $ echo 'ID=debian' > os/testing

  $ sources () { rm -rf apt; mkdir -p apt/sources.list.d apt/preferences.d; cat > apt/$1; }
  $ sources sources.list < /dev/null
  $ : > installed

[setup OS WHO TOOLS OPTION...] runs it without a terminal; root's WHO is 0. The
list of everything that is needed for building is long, and is shortened to ALL.

  $ full_setup () {
  >   os=$1 who=$2 tools=$3; shift 3
  >   env -i PATH=$PWD/$tools:$PWD/tools WHO=$who RAYLAB_OS_RELEASE=os/$os \
  >     RAYLAB_APT_DIR=apt bash ../../bin/setup "$@" < /dev/null 2>&1
  > }
  $ setup () {
  >   full_setup "$@" > out; code=$?
  >   sed 's/ocaml\(>=5.1\)* ocaml-findlib .* libyojson-ocaml-dev/ALL/' out
  >   return $code
  > }

The command line
----------------

  $ setup debian13 0 - --help
  Usage: bin/setup [--test] [--yes] [--dry-run]
  
  Installs what is missing to build and run raylab: OCaml 5.1 or later and the
  libraries, by apt on Debian and Ubuntu, elsewhere by opam.
  
    --test      install also what the tests need
    -y, --yes   ask nothing: the answer is yes
    --dry-run   print what would be done, and do nothing
    -h, --help  print this
  $ setup debian13 0 - --test --tset
  setup: unknown option '--tset'; see bin/setup --help
  [2]

Where apt has OCaml 5
---------------------

  $ full_setup debian13 0 - --dry-run
  setup: to be installed by apt: ocaml>=5.1 ocaml-findlib ocaml-dune>=3.17 menhir>=20230415 libmenhir-ocaml-dev utop libgraphics-ocaml-dev libx11-dev libzip-ocaml-dev libcmdliner-ocaml-dev libyojson-ocaml-dev
  env DEBIAN_FRONTEND=noninteractive apt-get update
  env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends ocaml ocaml-findlib ocaml-dune menhir libmenhir-ocaml-dev utop libgraphics-ocaml-dev libx11-dev libzip-ocaml-dev libcmdliner-ocaml-dev libyojson-ocaml-dev
  $ setup debian13 1000 sudo --dry-run --test
  setup: to be installed by apt: ALL libalcotest-ocaml-dev libqcheck-ocaml-dev ocamlformat>=0.27 ocaml-odoc tmux xvfb xdotool imagemagick netpbm libgdk-pixbuf2.0-bin libstb-dev slurm-wlm munge groff-base mandoc js-of-ocaml>=5 nodejs povray
  sudo env DEBIAN_FRONTEND=noninteractive apt-get update
  sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends ALL libalcotest-ocaml-dev libqcheck-ocaml-dev ocamlformat ocaml-odoc tmux xvfb xdotool imagemagick netpbm libgdk-pixbuf2.0-bin libstb-dev slurm-wlm munge groff-base mandoc js-of-ocaml nodejs povray
  $ setup testing 0 - --dry-run
  setup: to be installed by apt: ALL
  env DEBIAN_FRONTEND=noninteractive apt-get update
  env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends ALL
  $ setup ubuntu25 1000 sudo --dry-run
  setup: to be installed by apt: ALL
  sudo env DEBIAN_FRONTEND=noninteractive apt-get update
  sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends ALL

Without sudo, it is for somebody else to do.

  $ setup ubuntu25 1000 - --yes
  setup: to be installed by apt: ALL
  setup: this takes an administrator, and there is no sudo. Run as root:
  env DEBIAN_FRONTEND=noninteractive apt-get update
  env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends ALL
  [1]

Only what is missing is installed, or too old, or removed but for its settings.

  $ cat > installed <<EOF
  > ocaml 5.3.0-3 installed
  > ocaml-findlib 1.9.8-1+b1 installed
  > ocaml-dune 3.16.0-1 installed
  > menhir 20240715+ds-1+b2 installed
  > libmenhir-ocaml-dev 20240715+ds-1+b2 installed
  > utop 2.15.0-1+b9 config-files
  > libgraphics-ocaml-dev 5.1.2-3+b4 installed
  > libx11-dev 2:1.8.12-1 installed
  > libzip-ocaml-dev 1.13-1+b2 installed
  > libcmdliner-ocaml-dev 1.3.0-2+b3 installed
  > libyojson-ocaml-dev 2.2.2-1+b2 installed
  > EOF
  $ setup debian13 0 - --dry-run
  setup: to be installed by apt: ocaml-dune>=3.17 utop
  env DEBIAN_FRONTEND=noninteractive apt-get update
  env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends ocaml-dune utop

All of it is replaced if the compiler is too old.

  $ sed -i 's/^ocaml 5.3.0-3/ocaml 4.14.1-1/' installed
  $ setup debian13 0 - --dry-run
  setup: to be installed by apt: ALL
  env DEBIAN_FRONTEND=noninteractive apt-get update
  env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends ALL

Nothing to do: no root, no network and no question.

  $ sed -i 's/4.14.1-1/5.1.1-1/; s/3.16.0/3.17.2/; s/config-files/installed/' installed
  $ setup debian13 1000 -
  setup: everything is there already.
  $ setup debian12 1000 -
  setup: everything is there already.
  $ setup debian13 0 - --dry-run --test
  setup: to be installed by apt: libalcotest-ocaml-dev libqcheck-ocaml-dev ocamlformat>=0.27 ocaml-odoc tmux xvfb xdotool imagemagick netpbm libgdk-pixbuf2.0-bin libstb-dev slurm-wlm munge groff-base mandoc js-of-ocaml>=5 nodejs povray
  env DEBIAN_FRONTEND=noninteractive apt-get update
  env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends libalcotest-ocaml-dev libqcheck-ocaml-dev ocamlformat ocaml-odoc tmux xvfb xdotool imagemagick netpbm libgdk-pixbuf2.0-bin libstb-dev slurm-wlm munge groff-base mandoc js-of-ocaml nodejs povray
  $ : > installed

Debian 12
---------

The mirror and the key are those of the machine, not those of another archive.

  $ sources sources.list.d/debian.sources <<EOF
  > # Debian's own
  > Types: deb deb-src
  > URIs: http://mirror.example/debian
  > Suites: bookworm bookworm-updates
  > Components: main contrib
  > Signed-By: /usr/share/keyrings/debian.gpg
  > 
  > Types: deb
  > URIs: http://mirror.example/debian-security
  > Suites: bookworm-security
  > Components: main
  > EOF
  $ echo 'deb http://other.example/ bookworm main' > apt/sources.list.d/a.list
  $ setup debian12 0 - --dry-run
  setup: to be installed by apt: ALL
  setup: Debian 12's OCaml is too old: these come from Debian 13 (trixie), with what they depend on, the C library included. What was built for an older OCaml is removed.
  setup: trixie will be added to the sources of apt, from the same mirror.
  tee apt/preferences.d/raylab-trixie <<'EOF'
  Package: *
  Pin: release n=trixie
  Pin-Priority: 100
  EOF
  tee apt/sources.list.d/raylab-trixie.sources <<'EOF'
  Types: deb
  Suites: trixie
  Components: main
  URIs: http://mirror.example/debian
  Signed-By: /usr/share/keyrings/debian.gpg
  EOF
  env DEBIAN_FRONTEND=noninteractive apt-get update
  env DEBIAN_FRONTEND=noninteractive apt-get install -y -t trixie --no-install-recommends ALL

  $ sources sources.list <<EOF
  > deb-src http://sources.example/debian bookworm main
  > # deb http://old.example/debian bookworm main
  > deb [arch=amd64 signed-by=/etc/key.gpg] http://mirror.example/debian bookworm main # ours
  > EOF
  $ setup debian12 1000 sudo --dry-run --yes | sed -n '/sources.list.d/,/EOF$/p'
  sudo tee apt/sources.list.d/raylab-trixie.sources <<'EOF'
  Types: deb
  Suites: trixie
  Components: main
  URIs: http://mirror.example/debian
  Signed-By: /etc/key.gpg
  EOF

An ordinary user is asked first. There is nobody to ask here, unless it is --yes.

  $ setup debian12 1000 sudo --dry-run
  setup: to be installed by apt: ALL
  setup: Debian 12's OCaml is too old: these come from Debian 13 (trixie), with what they depend on, the C library included. What was built for an older OCaml is removed.
  setup: trixie will be added to the sources of apt, from the same mirror.
  setup: Add trixie? There is no terminal to ask on: add --yes to agree.
  [1]

Without sudo the commands can be pasted into a shell of root's.

  $ setup debian12 1000 -
  setup: to be installed by apt: ALL
  setup: Debian 12's OCaml is too old: these come from Debian 13 (trixie), with what they depend on, the C library included. What was built for an older OCaml is removed.
  setup: trixie will be added to the sources of apt, from the same mirror.
  setup: this takes an administrator, and there is no sudo. Run as root:
  tee apt/preferences.d/raylab-trixie <<'EOF'
  Package: *
  Pin: release n=trixie
  Pin-Priority: 100
  EOF
  tee apt/sources.list.d/raylab-trixie.sources <<'EOF'
  Types: deb
  Suites: trixie
  Components: main
  URIs: http://mirror.example/debian
  Signed-By: /etc/key.gpg
  EOF
  env DEBIAN_FRONTEND=noninteractive apt-get update
  env DEBIAN_FRONTEND=noninteractive apt-get install -y -t trixie --no-install-recommends ALL
  [1]

A suite trixie that is there already is enough, unless it is switched off.

  $ cat > apt/sources.list.d/b.sources <<EOF
  > Types: deb
  > URIs: http://mirror.example/debian
  > Suites:
  >  trixie
  >  trixie-updates
  > Components: main
  > EOF
  $ setup debian12 1000 sudo --dry-run | tail -n 2
  sudo env DEBIAN_FRONTEND=noninteractive apt-get update
  sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -t trixie --no-install-recommends ALL
  $ echo 'Enabled: no' >> apt/sources.list.d/b.sources
  $ setup debian12 1000 sudo --dry-run | tail -n 1
  setup: Add trixie? There is no terminal to ask on: add --yes to agree.

After that, trixie's os-release may be there; it is Debian 12 all the same.

  $ setup debian13 0 - --dry-run | tail -n 1
  env DEBIAN_FRONTEND=noninteractive apt-get install -y -t trixie --no-install-recommends ALL

A failure leaves apt as it was, and says what failed.

  $ rm apt/sources.list.d/b.sources
  $ setup debian12 0 -
  setup: to be installed by apt: ALL
  setup: Debian 12's OCaml is too old: these come from Debian 13 (trixie), with what they depend on, the C library included. What was built for an older OCaml is removed.
  setup: trixie will be added to the sources of apt, from the same mirror.
  + tee apt/preferences.d/raylab-trixie <<'EOF'
  Package: *
  Pin: release n=trixie
  Pin-Priority: 100
  EOF
  + tee apt/sources.list.d/raylab-trixie.sources <<'EOF'
  Types: deb
  Suites: trixie
  Components: main
  URIs: http://mirror.example/debian
  Signed-By: /etc/key.gpg
  EOF
  + env DEBIAN_FRONTEND=noninteractive apt-get update
  apt-get: no network
  setup: this command failed: env DEBIAN_FRONTEND=noninteractive apt-get update
  + rm -f apt/sources.list.d/raylab-trixie.sources apt/preferences.d/raylab-trixie
  [1]
  $ ls apt/*.d
  apt/preferences.d:
  
  apt/sources.list.d:

No source, no mirror:

  $ sources sources.list < /dev/null
  $ setup debian12 0 - --dry-run | tail -n 1
  setup: apt names no source of Debian's packages.

Elsewhere
---------

  $ setup ubuntu24 0 -
  setup: cannot install on Ubuntu 24.04 LTS. raylab needs Debian 12 or later, Ubuntu 25.04 or later, or opam, the package manager of OCaml.
  [1]
  $ setup nowhere 0 -
  setup: cannot install on this system. raylab needs Debian 12 or later, Ubuntu 25.04 or later, or opam, the package manager of OCaml.
  [1]

  $ cat > switch <<EOF
  > ocaml 5.2.1
  > dune  3.10.0
  > menhir 20240715
  > utop 2.15.0
  > ocamlformat 0.26.2
  > EOF
  $ setup ubuntu24 1000 opam --dry-run
  setup: to be installed by opam: dune>=3.17 graphics camlzip>=1.12 cmdliner=1.3.0 yojson>=2.0.0
  opam install dune\>=3.17 graphics camlzip\>=1.12 cmdliner=1.3.0 yojson\>=2.0.0
  setup: to put dune on the PATH, run: eval $(opam env)
  $ setup fedora 1000 opam --dry-run --test --yes
  setup: to be installed by opam: dune>=3.17 graphics camlzip>=1.12 cmdliner=1.3.0 yojson>=2.0.0 alcotest qcheck qcheck-alcotest ocamlformat=0.27.0 odoc js_of_ocaml-compiler
  opam install --yes dune\>=3.17 graphics camlzip\>=1.12 cmdliner=1.3.0 yojson\>=2.0.0 alcotest qcheck qcheck-alcotest ocamlformat=0.27.0 odoc js_of_ocaml-compiler
  setup: the tests need also, from the system: tmux, Xvfb, xdotool, ImageMagick, netpbm, gdk-pixbuf-pixdata, stb_image.h, Slurm (slurmctld and slurmd), munge, groff, mandoc, node and povray.
  setup: to put dune on the PATH, run: eval $(opam env)
  $ echo 'ocaml 4.14.2' > switch
  $ setup fedora 1000 opam --dry-run
  setup: opam's current switch has no OCaml 5.1 or later. Make one, and run bin/setup again:
      opam init --bare --no-setup   # if opam was never used before
      opam switch create raylab 5.3.0
      eval $(opam env --switch=raylab)
  [1]
  $ cat > switch <<EOF
  > ocaml 5.2.1
  > dune 3.20.1
  > menhir 20240715
  > utop 2.15.0
  > graphics 5.1.2
  > camlzip 1.13
  > cmdliner 1.3.0
  > yojson 2.2.2
  > EOF
  $ setup nowhere 1000 opam --dry-run
  setup: everything is there already.
  setup: to put dune on the PATH, run: eval $(opam env)

The rooms of lib/ are a chain: README.md names them in order, and each uses only
those before it.

  $ root=../..
  $ tr '\n' ' ' < $root/README.md | sed 's/.*is a chain of small libraries//; s/ `bin\/`.*//' |
  >   grep -o '`raylab\.[a-z_]*`' | tr -d '`' | sed 's/raylab\.//' > chain

All of them, and no others.

  $ for dune in $root/lib/*/dune; do basename $(dirname $dune); done | sort > rooms
  $ sort chain | diff - rooms

What a room uses stands before it.

  $ place() { grep -n "^$1\$" chain | cut -d : -f 1; }
  $ while read room; do
  >   for used in $(grep -o 'raylab_[a-z_]*' $root/lib/$room/dune | sed 's/raylab_//' | sort -u); do
  >     if [ $used != $room ] && [ $(place $used) -gt $(place $room) ]; then
  >       echo "$room uses $used, which stands after it"
  >     fi
  >   done
  > done < chain

The core knows neither X11 nor Unix, nor a library for files or prompts; reading
files is up to those who use it.

  $ for room in $(sed '/^picture$/,$d' chain); do
  >   grep -Eow 'unix|graphics|zip|utop|threads|lambda-term' $root/lib/$room/dune | sed "s/^/$room: /"
  > done

The picture of the rooms has each of them.

  $ for room in $(cat chain); do
  >   grep -q ">$room<" $root/doc/rooms.svg || echo "doc/rooms.svg lacks $room"
  > done

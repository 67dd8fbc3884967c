What happens to one domain of several.

  $ unset DISPLAY
  $ cat > hall.scene <<EOF
  > imWidth 200   imHeight 150   canvWidth 4   canvHeight 3   depth 4
  > raydepth 1000000
  > plane 0 0 9 0 0 1 reflective   plane 0 0 -9 0 0 1 reflective
  > EOF

A chain of a million rays does not fit on this small stack, in whichever domain
it is. That ends all of them, and no picture is there, new or with a hole.

  $ echo older > old.bmp
  $ for domains in 1 2 4; do
  >   for picture in old.bmp new.bmp; do
  >     OCAMLRUNPARAM=l=64k timeout -k 20 20 raylab render hall.scene -j $domains -o $picture
  >     echo "[$?]"
  >   done
  > done
  raylab: a chain of mirrored rays is too long for the stack that there is: make raydepth, which is 1000000, smaller
  [125]
  raylab: a chain of mirrored rays is too long for the stack that there is: make raydepth, which is 1000000, smaller
  [125]
  raylab: a chain of mirrored rays is too long for the stack that there is: make raydepth, which is 1000000, smaller
  [125]
  raylab: a chain of mirrored rays is too long for the stack that there is: make raydepth, which is 1000000, smaller
  [125]
  raylab: a chain of mirrored rays is too long for the stack that there is: make raydepth, which is 1000000, smaller
  [125]
  raylab: a chain of mirrored rays is too long for the stack that there is: make raydepth, which is 1000000, smaller
  [125]
  $ cat old.bmp
  older
  $ ls -A
  hall.scene
  old.bmp

Where the system grants no further domain, here since there is no room for its
stack, those that there are do the work.

  $ sed s/1000000/9/ hall.scene > short.scene
  $ raylab render short.scene -j 1 -q -o one.bmp
  $ (ulimit -s 4000000 && ulimit -v 3000000 && raylab render short.scene -j 4 -q -o four.bmp)
  $ cmp one.bmp four.bmp

There may be as many as the runtime can have, and not one more.

  $ raylab render short.scene -j 128 -q -o many.bmp
  $ cmp one.bmp many.bmp
  $ raylab render short.scene -j 129 -q -o more.bmp 2>&1 | head -n 1
  raylab: option '-j': '129' is not a number of domains from 1 to 128
  $ test ! -e more.bmp

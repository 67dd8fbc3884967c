What is no regular file, and what is open, is not replaced: the picture is
written to it, after what is there.

  $ unset DISPLAY
  $ cat > sky.scene <<EOF
  > imWidth 4   imHeight 3   canvWidth 4   canvHeight 3   depth 4
  > bcolor 0.2 0.4 0.6
  > lights spherical 20 white 0 3 3
  > plane 0 -1 0  0 1 0   diffusive white
  > EOF
  $ raylab render sky.scene -q
  $ { echo before; cat sky.bmp; echo after; } > expected

Standard output, which goes to a file here, by any of its names. Nothing is told
then, as with "-o -".

  $ for name in - /dev/stdout /dev/fd/1 /proc/self/fd/1; do
  >   { echo before; raylab render sky.scene -o $name; echo after; } > all
  >   cmp all expected
  > done
  $ ln -s /dev/stdout link
  $ { echo before; raylab render sky.scene -o link; echo after; } > all
  $ cmp all expected

Another descriptor:

  $ { echo before; raylab render sky.scene -o /dev/fd/5 >&2; echo after; } 5> all >&5
  raylab: wrote /dev/fd/5
  $ cmp all expected

A pipe, in a folder or made by the shell, and a device:

  $ mkfifo pipe
  $ cat pipe > got & raylab render sky.scene -o pipe; wait
  raylab: wrote pipe
  $ cmp got sky.bmp && test -p pipe
  $ bash -c 'raylab render sky.scene -q -o >(cat > got); wait $!'
  $ cmp got sky.bmp
  $ raylab render sky.scene -q -o /dev/null

What another process has open is appended to: here, what the shell has.

  $ echo before > all
  $ bash -c 'raylab render sky.scene -q -o /proc/$$/fd/5 5>&-; true' 5<> all
  $ echo after >> all
  $ cmp all expected

Other commands do so too. Nothing else goes to standard output then.

  $ raylab render sky.scene --rows 0-1 -q -o top.ppm
  $ raylab render sky.scene --rows 2-2 -q -o rest.ppm
  $ { echo before; raylab join top.ppm rest.ppm -o /dev/stdout; echo after; } > all
  $ cmp all expected
  $ raylab explain sky.scene 1,1 --svg path.svg > text
  $ raylab explain sky.scene 1,1 --svg /dev/stdout | cmp - path.svg
  $ raylab explain sky.scene 1,1 --json --svg /dev/stdout
  raylab: option --svg: only one thing can go to standard output
  [124]
  $ { echo before; cat text; echo before; cat path.svg; } > expected
  $ { echo before; raylab explain sky.scene 1,1 --svg /dev/fd/5; } 5> drawn > all
  $ { echo before; cat drawn; } >> all
  $ cmp all expected
  $ raylab view sky.scene -o /dev/stdout
  raylab: option -o: explanations go to standard output
  [124]
  $ raylab slurm sky.scene -o /dev/stdout --bands 2
  raylab: option -o: a job has no standard output for a picture; name a file
  [124]
  $ echo 'save "/dev/fd/5"' | raylab repl sky.scene 5> all
  wrote /dev/fd/5
  - : unit = ()
  $ cmp all sky.bmp

Standard input and output in the place of files.

  $ unset DISPLAY
  $ cat > sky.scene <<EOF
  > imWidth 2   imHeight 1   canvWidth 2   canvHeight 1   depth 1
  > bcolor 0.2 0.4 0.6
  > plane 0 0 1  1 0 0   luminous white
  > EOF
  $ raylab render sky.scene -q

"-o -" is standard output, as BMP. There is nothing there but the picture, also
if much is said.

  $ raylab render sky.scene -o - > out.bmp
  $ cmp sky.bmp out.bmp
  $ raylab render sky.scene --stats -j 2 -o - 2> err > out.bmp
  $ cmp sky.bmp out.bmp
  $ grep -c rays err
  5

Without the command too.

  $ raylab sky.scene -o - | cmp - sky.bmp

Another format has to be asked for.

  $ for format in bmp png ppm; do
  >   raylab render sky.scene -q -o sky.$format
  >   raylab render sky.scene -o - --format $format | cmp - sky.$format
  > done
  $ raylab sky.scene -o - --format=PNG | cmp - sky.png

"-" is standard input. Its scene has no name after which a picture could be
called, so there must be one.

  $ raylab render - -o in.bmp < sky.scene
  raylab: wrote in.bmp
  $ cmp sky.bmp in.bmp
  $ raylab - -o in.ppm < sky.scene
  raylab: wrote in.ppm
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ cat sky.scene | raylab render - -o - | cmp - sky.bmp
  $ raylab render - < sky.scene
  raylab: a scene from standard input has no name to call its picture after: say where it goes with -o
  [124]
  $ raylab - < sky.scene
  raylab: a scene from standard input has no name to call its picture after: say where it goes with -o
  [124]

An error in it has a place too.

  $ echo 'imWidth none' | raylab render - -o - > out 2> err
  [1]
  $ head -n 1 err
  <standard input>:1:9-12: error: 'none' is not a number
  $ wc -c < out
  0

A file can be called "-".

  $ raylab render sky.scene -o ./-
  raylab: wrote ./-
  $ cp sky.scene ./-
  $ raylab render ./- -o - | cmp - sky.bmp

A reader that does not want all of the picture ends the run as it ends that of
other programs: it dies of SIGPIPE, quietly, also if that was ignored before. The
picture must be larger than what a pipe holds.

  $ unread () {
  >   sigpipe=$1; shift
  >   { env --$sigpipe-signal=PIPE raylab "$@" 2> err; echo $? > code; } |
  >     head -c 1 > start
  >   cat code err
  > }
  $ large='sky.scene --size 640x320'
  $ unread default render $large -o -
  141
  $ unread ignore render $large -o -
  141
  $ unread default render $large --rows 0-319 -o /dev/stdout
  141

So it is with all that can be read, and with any pipe.

  $ raylab render $large --rows 0-319 -q -o band.ppm
  $ unread default join band.ppm -o -
  141
  $ is_gone () {
  >   bash -c 'exec 5> >(:); wait $!; "$@" >&5 2> err; echo $? $(cat err)' - "$@"
  > }
  $ is_gone raylab explain sky.scene 1,0
  141
  $ is_gone raylab explain sky.scene 1,0 --json
  141
  $ is_gone raylab explain sky.scene 1,0 --steps
  141
  $ is_gone raylab explain sky.scene 1,0 --svg -
  141
  $ is_gone raylab explain sky.scene 1,0 --svg /dev/fd/5
  141
  $ is_gone raylab render sky.scene -o /dev/fd/5
  141
  $ is_gone raylab --version
  141
  $ is_gone raylab render --help=plain
  141
  $ echo 'why 1 0;;' > words
  $ is_gone raylab repl sky.scene < words
  141
  $ mkfifo unread
  $ : < unread & is_gone raylab render $large -o unread; wait
  141

A message that nobody reads is not missed, and the work is done.

  $ is_gone sh -c 'raylab render sky.scene -o d.bmp 2>&1'
  0
  $ cmp d.bmp sky.bmp
  $ is_gone sh -c 'raylab check missing.scene 2>&1'
  1

A closed standard output, and a full one, are errors. There may be scene errors
to tell all the same.

  $ raylab render sky.scene -o - >&-
  raylab: standard output: Bad file descriptor
  [2]
  $ raylab render sky.scene -o - > /dev/full
  raylab: standard output: No space left on device
  [2]
  $ raylab render sky.scene --size 640x320 -o - > /dev/full
  raylab: standard output: No space left on device
  [2]
  $ raylab --version > /dev/full
  raylab: standard output: No space left on device
  [2]
  $ raylab explain --help=plain >&-
  raylab: standard output: Bad file descriptor
  [2]
  $ raylab check missing.scene >&-
  missing.scene: error: No such file or directory
  [1]

A picture for a file needs neither of the two.

  $ raylab render sky.scene -o a.bmp <&- >&-
  raylab: wrote a.bmp
  $ cmp a.bmp sky.bmp

Nor does it need standard error.

  $ raylab render sky.scene -o b.bmp --stats 2>&-
  $ raylab render sky.scene -o c.bmp --stats 2> /dev/full
  $ cmp b.bmp sky.bmp && cmp c.bmp sky.bmp
  $ raylab check missing.scene 2>&-
  [1]
  $ raylab check missing.scene 2> /dev/full
  [1]

Standard input by another name, and a pipe, have no name either. They are read
once.

  $ raylab render /dev/stdin < sky.scene
  raylab: a scene from standard input has no name to call its picture after: say where it goes with -o
  [124]
  $ raylab /proc/self/fd/0 < sky.scene
  raylab: a scene from standard input has no name to call its picture after: say where it goes with -o
  [124]
  $ mkfifo pipe && ln -s pipe link
  $ raylab render link
  raylab: a scene from link has no name to call its picture after: say where it goes with -o
  [124]
  $ cat sky.scene > pipe & raylab render link -o - | cmp - sky.bmp; wait
  $ raylab render /dev/stdin -o - < sky.scene | cmp - sky.bmp
  $ raylab view /dev/stdin --watch < sky.scene
  raylab: option --watch: standard input cannot be watched
  [124]
  $ raylab view link --watch
  raylab: option --watch: link cannot be watched
  [124]
  $ raylab repl /dev/stdin < sky.scene
  raylab: a scene from standard input leaves nothing for the prompt to read
  [124]

Wrong command lines, which end with exit status 124, and right ones for help.

  $ cat > a.scene <<EOF
  > imWidth 4   imHeight 3   canvWidth 4   canvHeight 3   depth 4
  > plane 0 0 6 0 0 1 luminous red
  > EOF
  $ cp a.scene b.scene

What is wrong is told before the usage, which is left out here.

  $ usage () {
  >   raylab "$@" > out 2> err; code=$?
  >   cat out; sed '/^Usage:/,$d' err; return $code
  > }

Commands: none, unknown, misspelt, too many scenes.

  $ usage
  raylab: required argument SCENE is missing
  [124]
  $ usage rander a.scene
  raylab: unknown command 'rander', did you mean 'render'?
  [124]
  $ usage chek
  raylab: unknown command 'chek', did you mean 'check'?
  [124]
  $ usage no_such_command_or_file
  raylab: unknown command 'no_such_command_or_file', must be one of 'check', 'explain', 'help', 'join', 'render', 'repl', 'slurm' or 'view'.
  [124]
  $ usage render
  raylab: required argument SCENE is missing
  [124]
  $ usage check
  raylab: required argument SCENE is missing
  [124]
  $ usage a.scene b.scene
  raylab: too many arguments, don't know what to do with 'b.scene'
  [124]
  $ usage render a.scene b.scene
  raylab: too many arguments, don't know what to do with 'b.scene'
  [124]

Options: unknown, without a value, twice.

  $ usage render a.scene --sise 3x3
  raylab: unknown option '--sise', did you mean '--size'?
  [124]
  $ usage render a.scene -z
  raylab: unknown option '-z'.
  [124]
  $ usage render a.scene -o
  raylab: option '-o' needs an argument
  [124]
  $ usage render a.scene -o a.bmp -o b.bmp
  raylab: option '-o' cannot be repeated
  [124]
  $ usage check a.scene -j 2
  raylab: unknown option '-j'.
  [124]

Domains:

  $ usage render a.scene -j 0
  raylab: option '-j': '0' is not a number of domains from 1 to 128
  [124]
  $ usage render a.scene -j 1000
  raylab: option '-j': '1000' is not a number of domains from 1 to 128
  [124]
  $ usage render a.scene -j -1
  raylab: unknown option '-1'.
  [124]
  $ usage render a.scene -j two
  raylab: option '-j': 'two' is not a number of domains from 1 to 128
  [124]
  $ usage render a.scene -j 99999999999999999999
  raylab: option '-j': '99999999999999999999' is not a number of domains from 1
          to 128
  [124]

Size:

  $ usage render a.scene --size 0x10
  raylab: option '--size': '0x10' is not a size: expected width and height in
          pixels, such as 640x480
  [124]
  $ usage render a.scene --size 10
  raylab: option '--size': '10' is not a size: expected width and height in
          pixels, such as 640x480
  [124]
  $ usage render a.scene --size 10x
  raylab: option '--size': '10x' is not a size: expected width and height in
          pixels, such as 640x480
  [124]
  $ usage render a.scene --size 1x2x3
  raylab: option '--size': '1x2x3' is not a size: expected width and height in
          pixels, such as 640x480
  [124]
  $ usage render a.scene --size 1e3x2
  raylab: option '--size': '1e3x2' is not a size: expected width and height in
          pixels, such as 640x480
  [124]
  $ usage render a.scene --size 99999999999999999999x1
  raylab: option '--size': '99999999999999999999x1' is not a size: expected
          width and height in pixels, such as 640x480
  [124]

Rows:

  $ usage render a.scene --rows 2-1
  raylab: option '--rows': '2-1' is not a band of rows: expected the first and
          the last, such as 0-99
  [124]
  $ usage render a.scene --rows 1
  raylab: option '--rows': '1' is not a band of rows: expected the first and
          the last, such as 0-99
  [124]
  $ usage render a.scene --rows -1-2
  raylab: unknown option '-1'.
  [124]
  $ usage render a.scene --rows 1-3
  raylab: option --rows: the picture has no row 3; its rows are 0 to 2
  [124]
  $ usage render a.scene --rows 0-99999999999999999999
  raylab: option '--rows': '0-99999999999999999999' is not a band of rows:
          expected the first and the last, such as 0-99
  [124]
  $ usage render a.scene --size 9x8 --rows 8-8
  raylab: option --rows: the picture has no row 8; its rows are 0 to 7
  [124]

Format:

  $ usage render a.scene -o - --format gif
  raylab: option '--format': 'gif' is not a picture format: expected bmp, png
          or ppm
  [124]
  $ usage render a.scene -o a.bmp --format png
  raylab: a.bmp: the extension says another format than --format does; leave one of them out
  [124]
  $ usage a.scene -o a.jpg --format png
  raylab: a.jpg: there is no picture format '.jpg'; use .bmp, .png or .ppm
  [124]

An output that is no picture, or that is the scene itself, by whatever name:

  $ usage render a.scene -o a.gif
  raylab: a.gif: there is no picture format '.gif'; use .bmp, .png or .ppm
  [124]
  $ usage render a.scene -o .png
  raylab: .png: there is no name before the extension; put one there
  [124]
  $ usage render a.scene -o some/.hidden
  raylab: some/.hidden: there is no name before the extension; put one there
  [124]
  $ usage view a.scene -o .png
  raylab: .png: there is no name before the extension; put one there
  [124]
  $ usage slurm a.scene -o .png --bands 2
  raylab: .png: there is no name before the extension; put one there
  [124]
  $ usage render a.scene -o a.scene
  raylab: a.scene is the scene; the picture would replace it
  [124]
  $ usage render a.scene -o ./a.scene
  raylab: ./a.scene is the scene; the picture would replace it
  [124]
  $ ln -s a.scene soft.bmp
  $ usage render a.scene -o soft.bmp
  raylab: soft.bmp is the scene; the picture would replace it
  [124]
  $ ln a.scene hard.bmp
  $ usage render a.scene -o hard.bmp
  raylab: hard.bmp is the scene; the picture would replace it
  [124]
  $ ln -s soft.bmp soft.scene
  $ usage soft.scene
  raylab: soft.bmp is the scene; the picture would replace it
  [124]
  $ cmp a.scene b.scene

Nothing was written by any of these.

  $ ls -A
  a.scene
  b.scene
  err
  hard.bmp
  out
  soft.bmp
  soft.scene

The whole of what is printed:

  $ raylab render a.scene --size 0x10
  raylab: option '--size': '0x10' is not a size: expected width and height in
          pixels, such as 640x480
  Usage: raylab render [OPTION]… SCENE
  Try 'raylab render --help' or 'raylab --help' for more information.
  [124]

Help and version go to standard output. A version is no place-holder.

  $ raylab --version | grep '%%'
  [1]
  $ raylab --help=plain
  NAME
         raylab - a ray tracer that can explain itself
  
  SYNOPSIS
         raylab [COMMAND] …
  
  DESCRIPTION
         raylab renders a scene, described by a short text file, by ray
         tracing.
  
         raylab SCENE, without the name of a command, renders SCENE, saves the
         picture beside it, under its name with .bmp, and shows it in a window
         if there is a display.
  
         The language of scenes has a manual, raylab-scene(5). The folder
         doc/raylab of what raylab is installed in, such as
         ~/.local/doc/raylab, holds it with pictures, doc/language.md, a
         gallery of scenes, scenes, and a lesson at the prompt,
         scenes/why-black.md.
  
  COMMANDS
         check [--allow=DIR] [--expand] [--json] [OPTION]… SCENE…
             report the errors and warnings of scenes
  
         explain [OPTION]… SCENE X,Y…
             say why pixels have their colours
  
         help [OPTION]… [COMMAND]
             show the manual of a command
  
         join [--format=FORMAT] [--output=OUT] [--quiet] [OPTION]… PART…
             put bands of a picture together
  
         render [OPTION]… SCENE
             render a scene to a picture file
  
         repl [--allow=DIR] [OPTION]… [SCENE] [SCRIPT]
             explore a scene at OCaml's prompt
  
         slurm [OPTION]… SCENE
             render a picture in bands, on a cluster
  
         view [OPTION]… SCENE
             show a scene in a window
  
  ARGUMENTS
         SCENE (required)
             The scene file, or - for standard input.
  
  OPTIONS
         --allow=DIR
             Files that SCENE includes may also be in the folder DIR or below
             it, and not only in that of SCENE. It may be given several times.
  
         --exposure=K
             Show every colour K times as bright, whatever the scene says.
  
         --format=FORMAT
             Write the picture in FORMAT: bmp, png or ppm. The extension of
             OUT, if there is one, must say the same.
  
         --grey, --gray
             Render in greyscale: take every colour of the scene by its
             luminance.
  
         -j DOMAINS, --domains=DOMAINS
             Render on DOMAINS domains at once, by default one for each core.
             The picture is the same, byte for byte.
  
         -o OUT, --output=OUT
             Write the picture to OUT. Its extension says in which format:
             .bmp, .png or .ppm; without extension, and on standard output,
             which is -, it is BMP, or what --format says. By default the
             picture goes beside the scene, under its name with the extension
             of the format in the place of .scene or .txt. A picture that is
             already there is replaced.
  
         -q, --quiet
             Print neither progress nor warnings, nor where the picture went.
  
         --rows=A-B
             Render only rows A-B, both included, counted from 0 at the top.
             The picture holds just these rows, and says in its file where they
             belong: raylab join puts such bands together.
  
         --samples=N
             Take up to N samples of each pixel, whatever the scene says: as
             many as the pixel needs. 1 makes edges of steps, 16 smooth ones.
  
         --show
             Then show the picture in a window, as raylab view does. Without a
             display it is written all the same, and this is no failure.
  
         --size=WxH
             Make the picture WxH pixels large, whatever the scene says. It
             shows the same canvas, stretched if its proportions differ.
  
         --srgb
             Show colours by the sRGB curve, as screens expect light to be
             written. Dark colours become brighter.
  
         --stats
             Print the rays by kind, hits, time and rays per second to standard
             error.
  
  COMMON OPTIONS
         -h  Show this help, as --help does.
  
         --help[=FMT] (default=auto)
             Show this help in format FMT. The value FMT must be one of auto,
             pager, groff or plain. With auto, the format is pager or plain
             whenever the TERM env var is dumb or undefined.
  
         --version
             Show version information.
  
  EXIT STATUS
         raylab exits with:
  
         0   on success.
  
         1   if the scene is in error or cannot be read, or if bands do not
             make a picture.
  
         2   if a picture or other output could not be written, not shown for
             want of a display, or a job not submitted.
  
         124 if the command line is wrong.
  
         125 if memory runs out, or on an error of raylab itself.
  
         129 if the terminal went away; a picture that is not whole is not
             written.
  
         130 if interrupted by Ctrl-C; a picture that is not whole is not
             written.
  
         141 if the reader of its output went away: it dies of SIGPIPE, without
             a word, as other programs do.
  
         143 if ended by a signal; a picture that is not whole is not written.
  
  SEE ALSO
         raylab-scene(5)
  
  $ raylab render --help=plain
  NAME
         raylab-render - render a scene to a picture file
  
  SYNOPSIS
         raylab render [OPTION]… SCENE
  
  DESCRIPTION
         Renders SCENE and writes the picture to a file, which appears whole or
         not at all. What is known to fail is told before there is any work.
  
         A file that cannot be replaced, such as a mount point or one in a
         folder that may not be written to, gets the finished picture copied
         over it, which is told. A pipe, a device and what is open, such as
         /dev/fd/3, are written through: what is there stays.
  
         While it works, and if standard error is a terminal, it shows how far
         it is and how long the rest will take.
  
  ARGUMENTS
         SCENE (required)
             The scene file, or - for standard input.
  
  OPTIONS
         --allow=DIR
             Files that SCENE includes may also be in the folder DIR or below
             it, and not only in that of SCENE. It may be given several times.
  
         --exposure=K
             Show every colour K times as bright, whatever the scene says.
  
         --format=FORMAT
             Write the picture in FORMAT: bmp, png or ppm. The extension of
             OUT, if there is one, must say the same.
  
         --grey, --gray
             Render in greyscale: take every colour of the scene by its
             luminance.
  
         -j DOMAINS, --domains=DOMAINS
             Render on DOMAINS domains at once, by default one for each core.
             The picture is the same, byte for byte.
  
         -o OUT, --output=OUT
             Write the picture to OUT. Its extension says in which format:
             .bmp, .png or .ppm; without extension, and on standard output,
             which is -, it is BMP, or what --format says. By default the
             picture goes beside the scene, under its name with the extension
             of the format in the place of .scene or .txt. A picture that is
             already there is replaced.
  
         -q, --quiet
             Print neither progress nor warnings, nor where the picture went.
  
         --rows=A-B
             Render only rows A-B, both included, counted from 0 at the top.
             The picture holds just these rows, and says in its file where they
             belong: raylab join puts such bands together.
  
         --samples=N
             Take up to N samples of each pixel, whatever the scene says: as
             many as the pixel needs. 1 makes edges of steps, 16 smooth ones.
  
         --show
             Then show the picture in a window, as raylab view does. Without a
             display it is written all the same, and this is no failure.
  
         --size=WxH
             Make the picture WxH pixels large, whatever the scene says. It
             shows the same canvas, stretched if its proportions differ.
  
         --srgb
             Show colours by the sRGB curve, as screens expect light to be
             written. Dark colours become brighter.
  
         --stats
             Print the rays by kind, hits, time and rays per second to standard
             error.
  
  COMMON OPTIONS
         -h  Show this help, as --help does.
  
         --help[=FMT] (default=auto)
             Show this help in format FMT. The value FMT must be one of auto,
             pager, groff or plain. With auto, the format is pager or plain
             whenever the TERM env var is dumb or undefined.
  
         --version
             Show version information.
  
  EXIT STATUS
         raylab render exits with:
  
         0   on success.
  
         1   if the scene is in error or cannot be read, or if bands do not
             make a picture.
  
         2   if a picture or other output could not be written, not shown for
             want of a display, or a job not submitted.
  
         124 if the command line is wrong.
  
         125 if memory runs out, or on an error of raylab itself.
  
         129 if the terminal went away; a picture that is not whole is not
             written.
  
         130 if interrupted by Ctrl-C; a picture that is not whole is not
             written.
  
         141 if the reader of its output went away: it dies of SIGPIPE, without
             a word, as other programs do.
  
         143 if ended by a signal; a picture that is not whole is not written.
  
  SEE ALSO
         raylab(1), raylab-scene(5)
  
  $ raylab check --help=plain
  NAME
         raylab-check - report the errors and warnings of scenes
  
  SYNOPSIS
         raylab check [--allow=DIR] [--expand] [--json] [OPTION]… SCENE…
  
  DESCRIPTION
         Reads each SCENE and prints every error and warning to standard error.
         Renders nothing. Warnings do not change the exit status.
  
         Of each mesh it prints to standard output how many triangles it has,
         from where to where it goes, whether it is closed, or else where it is
         open, and which way its normals point.
  
  ARGUMENTS
         SCENE (required)
             The scene files, or - for standard input.
  
  OPTIONS
         --allow=DIR
             Files that SCENE includes may also be in the folder DIR or below
             it, and not only in that of SCENE. It may be given several times.
  
         --expand
             Print the scene as it was evaluated to standard output: one light
             or object a line, in the language of scenes, without names and
             loops, and behind each, as a comment, where it comes from.
  
         --json
             Print what is found as JSON to standard output, for other
             programs; see JSON below.
  
  COMMON OPTIONS
         -h  Show this help, as --help does.
  
         --help[=FMT] (default=auto)
             Show this help in format FMT. The value FMT must be one of auto,
             pager, groff or plain. With auto, the format is pager or plain
             whenever the TERM env var is dumb or undefined.
  
         --version
             Show version information.
  
  JSON
         With --json the output is
  
         { "version": 1, "scenes": [SCENE, ...] }
         
         SCENE   = { "scene": STRING,              its path, as it was given
                     "problems": [PROBLEM, ...],   in the order of the text
                     "meshes": [MESH, ...] }       if it has some
         
         PROBLEM = { "severity": "error" or "warning",
                     "file": STRING,               the path of the scene, or of a file
                                                   that it includes
                     "line": INT or null,          counted from 1; null: the whole file
                     "columns": [INT, INT]         the first and the last byte in the
                       or null,                    line, counted from 1
                     "message": STRING,            what is wrong, in one line
                     "remedy": STRING }            what to do; "" if there is no advice
         
         MESH    = { "file": STRING,               as explanations call it
                     "triangles": INT,
                     "low": VECTOR,                the corners of the box around it,
                     "high": VECTOR,               each [x, y, z]
                     "open": STRING or null,       where it is open; null: closed
                     "normals": "outward", "inward", "anyhow", or a VECTOR, along
                                                   which they point; of what is open
                                                   most of them }
  
         New members may be added; a change that breaks readers gets a new
         version.
  
  EXIT STATUS
         raylab check exits with:
  
         0   on success.
  
         1   if the scene is in error or cannot be read, or if bands do not
             make a picture.
  
         2   if a picture or other output could not be written, not shown for
             want of a display, or a job not submitted.
  
         124 if the command line is wrong.
  
         125 if memory runs out, or on an error of raylab itself.
  
         129 if the terminal went away; a picture that is not whole is not
             written.
  
         130 if interrupted by Ctrl-C; a picture that is not whole is not
             written.
  
         141 if the reader of its output went away: it dies of SIGPIPE, without
             a word, as other programs do.
  
         143 if ended by a signal; a picture that is not whole is not written.
  
  SEE ALSO
         raylab(1), raylab-scene(5)
  

There are other ways to ask for it.

  $ export TERM=dumb
  $ same () { raylab "$@" > out; raylab help $command | cmp - out; }
  $ command= ; same --help; same -h; same help
  $ for command in check explain help join render repl slurm view; do
  >   same $command --help; same $command -h; same help $command
  > done
  $ command=render; same a.scene -h; same render -q -h a.scene
  $ raylab check -- -h
  -h: error: No such file or directory
  [1]
  $ usage help rander
  raylab: there is no command 'rander'; raylab help lists them
  [124]

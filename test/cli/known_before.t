What must fail is known before there is any work. This picture, of two mirrors
that face each other, would take hours.

  $ unset DISPLAY
  $ cat > hall.scene <<EOF
  > imWidth 640   imHeight 480   canvWidth 4   canvHeight 3   depth 4
  > raydepth 1000000
  > plane 0 0 9 0 0 1 reflective   plane 0 0 -9 0 0 1 reflective
  > EOF
  $ at_once () { timeout 60 "$@"; }

A place where there can be no file:

  $ at_once raylab render hall.scene -o missing/hall.bmp
  raylab: missing/hall.bmp: No such file or directory
  [2]
  $ mkdir dir
  $ at_once raylab render hall.scene -o dir
  raylab: dir: is a directory
  [2]
  $ at_once raylab render hall.scene -o new/
  raylab: new/: Not a directory
  [2]
  $ at_once raylab render hall.scene -o hall.scene/hall.bmp
  raylab: hall.scene/hall.bmp: Not a directory
  [2]
  $ ln -s loop loop
  $ at_once raylab render hall.scene -o loop
  raylab: loop: Too many levels of symbolic links
  [2]
  $ ln -s missing/hall.bmp link
  $ at_once raylab render hall.scene -o link
  raylab: link: No such file or directory
  [2]
  $ at_once raylab render hall.scene -o $(printf '%0300d' 0) 2>&1 | grep -o '[^:]*$'
   File name too long

No room, for a picture of which it is known how large it is, or for any:

  $ (ulimit -f 100; at_once raylab render hall.scene -o hall.bmp; echo "[$?]")
  raylab: hall.bmp: File too large
  [2]
  $ (ulimit -f 100; at_once raylab render hall.scene --rows 1-300 -o hall.ppm; echo "[$?]")
  raylab: hall.ppm: File too large
  [2]
  $ (ulimit -f 0; at_once raylab render hall.scene -o hall.png; echo "[$?]") 2>&1 | cat
  raylab: hall.png: File too large
  [2]

Nothing that could be written to:

  $ at_once raylab render hall.scene -o - >&-
  raylab: standard output: Bad file descriptor
  [2]
  $ at_once raylab render hall.scene -o /dev/stdout >&-
  raylab: standard output: Bad file descriptor
  [2]
  $ at_once raylab render hall.scene -o /dev/fd/9 9>&-
  raylab: /dev/fd/9: Bad file descriptor
  [2]
  $ at_once raylab render hall.scene -o /dev/fd/9 9< /dev/null
  raylab: /dev/fd/9: Bad file descriptor
  [2]

Without an option it is the same.

  $ mkdir hall.bmp
  $ at_once raylab hall.scene
  raylab: hall.bmp: is a directory
  [2]
  $ rmdir hall.bmp

Other commands do not begin either. What joins bands reads none:

  $ raylab join missing.ppm -o missing/hall.bmp
  raylab: missing/hall.bmp: No such file or directory
  [2]
  $ raylab join missing.ppm -o - >&-
  raylab: standard output: Bad file descriptor
  [2]

The mirrors show one another a million times in this one pixel.

  $ at_once raylab explain hall.scene 3,3 --svg missing/path.svg
  raylab: missing/path.svg: No such file or directory
  [2]
  $ at_once raylab explain hall.scene 3,3 --svg - >&-
  raylab: standard output: Bad file descriptor
  [2]

A job for a cluster is not written, nor does a window open, whose key could not
save what was asked for.

  $ raylab slurm hall.scene -o missing/hall.bmp --bands 2
  raylab: missing/hall.bmp: No such file or directory
  [2]
  $ raylab slurm hall.scene -o loop --bands 2
  raylab: loop: Too many levels of symbolic links
  [2]
  $ raylab view hall.scene -o missing/hall.bmp
  raylab: missing/hall.bmp: No such file or directory
  [2]

At the prompt:

  $ echo 'save "missing/hall.bmp"' | at_once raylab repl hall.scene
  Exception: Sys_error "missing/hall.bmp: No such file or directory".

Nothing was left anywhere.

  $ ls -A . dir
  .:
  dir
  hall.scene
  link
  loop
  
  dir:

What "raylab slurm" writes. ./cluster.t runs it on a real Slurm.

  $ cat > sky.scene <<EOF
  > imWidth 3   imHeight 10   canvWidth 3   canvHeight 10   depth 4
  > bcolor 0.2 0.4 0.6   sphere 0 0 -9 1 luminous white
  > EOF
  $ raylab slurm sky.scene -o sky.png --bands 4 --size 6x10 --grey -j 2
  raylab: warning: --size 6x10 distorts the picture, which looks 2 times as wide as it should; 6x20 would not
  raylab: wrote $TESTCASE_ROOT/sky.slurm; to submit it, run $TESTCASE_ROOT/sky.slurm/submit
  $ ls sky.slurm
  bands
  bands.sbatch
  join.sbatch
  log
  picture.scene
  submit
  $ cmp sky.scene sky.slurm/picture.scene
  $ cat sky.slurm/submit
  #!/bin/bash
  # Submits the bands that are not there yet, and the job that joins them. Written
  # by raylab slurm; run it again when something has failed.
  cd -- "$(dirname -- "$0")" || exit
  bands=4
  
  # Nobody needs to read what is said: both jobs are submitted all the same.
  trap '' PIPE
  say() { echo "$@" 2>/dev/null || true; }
  
  # Ranges of missing bands, such as 1-5,8: a command line has room for few names.
  missing='' lowest='' last=0
  for ((band = 1; band <= bands; band++)); do
    if [ -e "bands/$band.ppm" ]; then continue; fi
    first=$band
    while [ "$band" -lt "$bands" ] && [ ! -e "bands/$((band + 1)).ppm" ]; do
      ((band++))
    done
    last=$band lowest=${lowest:-$first}
    if [ "$first" = "$last" ]; then range=$last; else range=$first-$last; fi
    missing+=${missing:+,}$range
  done
  # So many gaps that they are too long: a band that is there is left alone.
  if [ ${#missing} -gt 100000 ]; then missing=$lowest-$last; fi
  
  after=()
  if [ -n "$missing" ]; then
    limit=$(scontrol show config 2>/dev/null | sed -n 's/^MaxArraySize *= *//p')
    if [ -n "$limit" ] && [ "$last" -ge "$limit" ]; then
      echo "This cluster takes at most $((limit - 1)) bands (its" \
        "MaxArraySize is $limit), not $bands. Remove $PWD and" \
        "make the job with fewer." >&2
      exit 1
    fi
    job=$(sbatch --parsable --array="$missing" bands.sbatch) || exit
    job=${job%%;*} # the name of a cluster may follow
    say "job $job renders bands $missing"
    # after failures as well: it says which rows are missing
    after=(--dependency="afterany:$job")
  fi
  job=$(sbatch --parsable "${after[@]}" join.sbatch) || exit
  say "job ${job%%;*} joins them"
  $ show () { sed "s|^raylab='.*|raylab=...|" "$@"; }
  $ show sky.slurm/join.sbatch
  #!/bin/bash
  # Joins the bands of a picture. Written by raylab slurm; edit it as you like.
  #SBATCH --job-name=raylab-sky-join
  #SBATCH --output=log/join.txt
  #SBATCH --open-mode=append
  #SBATCH --requeue
  
  raylab=...
  if [ -n "$RAYLAB" ]; then raylab=$RAYLAB; fi
  
  "$raylab" join bands -q -o '$TESTCASE_ROOT/sky.png'
  $ show sky.slurm/bands.sbatch
  #!/bin/bash
  # Renders the bands of a picture, one a task. Written by raylab slurm; edit it
  # as you like. A band appears whole or not at all, and one that is there is left
  # alone, so that tasks may run twice.
  #SBATCH --job-name=raylab-sky
  #SBATCH --array=1-4
  #SBATCH --cpus-per-task=2
  #SBATCH --output=log/band-%a.txt
  #SBATCH --open-mode=append
  #SBATCH --requeue
  
  raylab=...
  if [ -n "$RAYLAB" ]; then raylab=$RAYLAB; fi
  view=('--size' '6x10' '--grey')
  height=10 bands=4
  
  band=$SLURM_ARRAY_TASK_ID
  part=bands/$band.ppm
  if [ -e "$part" ]; then exit; fi
  first=$(((band - 1) * height / bands))
  last=$((band * height / bands - 1))
  
  # A lost node is for Slurm to replace (--requeue above). A failure is tried
  # again here, unless it is one of the scene (1) or of the command line (124).
  for try in 1 2 3; do
    "$raylab" render picture.scene "${view[@]}" --rows "$first-$last" \
      -j "${SLURM_CPUS_PER_TASK:-1}" -q -o "$part"
    status=$?
    if [ "$status" = 0 ]; then exit; fi
    echo "rows $first-$last, try $try: exit status $status" >&2
    if [ "$status" = 1 ] || [ "$status" = 124 ]; then break; fi
    sleep "$try"
  done
  exit "$status"

They are right for bash, also where names have any characters, which stand for
themselves.

  $ check () { for script in bands.sbatch join.sbatch submit; do bash -n "$1/$script"; done; }
  $ check sky.slurm
  $ if command -v shellcheck > /dev/null; then shellcheck sky.slurm/*sbatch sky.slurm/submit; fi
  $ odd=$(printf "it's \$a \"d\`i\`r\"\n#SBATCH --x")
  $ mkdir "$odd"
  $ raylab slurm - -o "$odd/-my \$pic%a.ppm" --bands 3 2> err < sky.scene
  $ check "$odd/-my \$pic%a.slurm"
  $ grep -h '^#SBATCH --job' "$odd/-my \$pic%a.slurm"/*.sbatch
  #SBATCH --job-name=raylab--my__pic_a
  #SBATCH --job-name=raylab--my__pic_a-join

The scripts need no Slurm, only the number of the band. It may be rendered twice,
at the same time.

  $ cd sky.slurm
  $ for band in 4 2 1 3; do SLURM_ARRAY_TASK_ID=$band bash bands.sbatch; done
  $ rm bands/2.ppm
  $ SLURM_ARRAY_TASK_ID=2 bash bands.sbatch & SLURM_ARRAY_TASK_ID=2 bash bands.sbatch; wait
  $ ls -A bands
  1.ppm
  2.ppm
  3.ppm
  4.ppm
  $ bash join.sbatch
  $ cd ..
  $ raylab render sky.scene --size 6x10 --grey -q -o whole.png
  $ cmp sky.png whole.png
  $ cd "$odd/-my \$pic%a.slurm"
  $ for band in 1 2 3; do SLURM_ARRAY_TASK_ID=$band bash bands.sbatch; done
  $ bash join.sbatch
  $ cd "$OLDPWD"
  $ raylab render sky.scene -q -o whole.ppm
  $ cmp "$odd/-my \$pic%a.ppm" whole.ppm

A band that is there is left alone. One that would fail again is tried once, one
that may not three times.

  $ cat > raylab-that-fails <<'EOF'
  > #!/bin/sh
  > echo "$*"
  > exit $STATUS
  > EOF
  $ chmod +x raylab-that-fails
  $ task () { (cd sky.slurm; RAYLAB=../raylab-that-fails STATUS=$1 SLURM_ARRAY_TASK_ID=3 bash bands.sbatch 2>&1); }
  $ task 2
  $ rm sky.slurm/bands/3.ppm
  $ task 1
  render picture.scene --size 6x10 --grey --rows 5-6 -j 1 -q -o bands/3.ppm
  rows 5-6, try 1: exit status 1
  [1]
  $ task 124
  render picture.scene --size 6x10 --grey --rows 5-6 -j 1 -q -o bands/3.ppm
  rows 5-6, try 1: exit status 124
  [124]
  $ sed -i 's/sleep/: sleep/' sky.slurm/bands.sbatch
  $ task 143
  render picture.scene --size 6x10 --grey --rows 5-6 -j 1 -q -o bands/3.ppm
  rows 5-6, try 1: exit status 143
  render picture.scene --size 6x10 --grey --rows 5-6 -j 1 -q -o bands/3.ppm
  rows 5-6, try 2: exit status 143
  render picture.scene --size 6x10 --grey --rows 5-6 -j 1 -q -o bands/3.ppm
  rows 5-6, try 3: exit status 143
  [143]

Submitting
----------

Here sbatch only says what it is asked for.

  $ mkdir tools
  $ cat > tools/sbatch <<'EOF'
  > #!/bin/sh
  > echo "sbatch $*" >&2
  > echo "17;cluster"
  > exit ${STATUS-0}
  > EOF
  $ chmod +x tools/sbatch
  $ PATH=$PWD/tools:$PATH
  $ sky.slurm/submit
  sbatch --parsable --array=3 bands.sbatch
  job 17 renders bands 3
  sbatch --parsable --dependency=afterany:17 join.sbatch
  job 17 joins them
  $ raylab slurm sky.scene -o new.bmp --bands 10 --submit
  sbatch --parsable --array=1-10 bands.sbatch
  job 17 renders bands 1-10
  sbatch --parsable --dependency=afterany:17 join.sbatch
  job 17 joins them

Both are submitted if nobody reads that, and this is no failure.

  $ bash -c 'exec 5> >(:); wait $!; raylab slurm sky.scene -o new.bmp --bands 10 --submit >&5'
  sbatch --parsable --array=1-10 bands.sbatch
  sbatch --parsable --dependency=afterany:17 join.sbatch

A failure of sbatch is one.

  $ STATUS=1 raylab slurm sky.scene -o new.bmp --bands 10 --submit
  sbatch --parsable --array=1-10 bands.sbatch
  raylab: $TESTCASE_ROOT/new.slurm/submit has failed; it may be run again
  [2]

What is missing is named in ranges, however many bands there are.

  $ raylab slurm sky.scene -o many.bmp --bands 60000 --size 1x60000 --submit
  raylab: warning: --size 1x60000 distorts the picture, which looks 1.8e+04 times as high as it should; 1x3 would not
  sbatch --parsable --array=1-60000 bands.sbatch
  job 17 renders bands 1-60000
  sbatch --parsable --dependency=afterany:17 join.sbatch
  job 17 joins them
  $ have () { printf "many.slurm/bands/%s.ppm\n" "$@" | xargs touch; }
  $ have 1 4 5 6 9 60000
  $ many.slurm/submit
  sbatch --parsable --array=2-3,7-8,10-59999 bands.sbatch
  job 17 renders bands 2-3,7-8,10-59999
  sbatch --parsable --dependency=afterany:17 join.sbatch
  job 17 joins them
  $ have $(seq 10 2 59999)
  $ many.slurm/submit
  sbatch --parsable --array=2-59999 bands.sbatch
  job 17 renders bands 2-59999
  sbatch --parsable --dependency=afterany:17 join.sbatch
  job 17 joins them

A cluster may take fewer.

  $ echo 'echo "MaxArraySize            = 60000"' > tools/scontrol
  $ chmod +x tools/scontrol
  $ many.slurm/submit
  sbatch --parsable --array=2-59999 bands.sbatch
  job 17 renders bands 2-59999
  sbatch --parsable --dependency=afterany:17 join.sbatch
  job 17 joins them
  $ touch many.slurm/bands/59999.ppm
  $ rm many.slurm/bands/60000.ppm
  $ many.slurm/submit
  This cluster takes at most 59999 bands (its MaxArraySize is 60000), not 60000. Remove $TESTCASE_ROOT/many.slurm and make the job with fewer.
  [1]
  $ rm tools/scontrol

Where there is none:

  $ raylab=$(command -v raylab)
  $ PATH=/missing $raylab slurm sky.scene -o new.bmp --bands 10 --submit
  raylab: there is no sbatch on the PATH: this machine cannot submit to Slurm. Where it can be done, run $TESTCASE_ROOT/new.slurm/submit
  [2]

A folder belongs to one job. Its scripts may be edited.

  $ raylab slurm sky.scene -o new.bmp --bands 9
  raylab: $TESTCASE_ROOT/new.slurm/bands.sbatch is of another job, or was edited. Run $TESTCASE_ROOT/new.slurm/submit to go on with that job, or remove $TESTCASE_ROOT/new.slurm to start anew
  [2]
  $ sed -i 's/0.2/0.3/' sky.scene
  $ raylab slurm sky.scene -o new.bmp --bands 10
  raylab: $TESTCASE_ROOT/new.slurm/picture.scene is of another job, or was edited. Run $TESTCASE_ROOT/new.slurm/submit to go on with that job, or remove $TESTCASE_ROOT/new.slurm to start anew
  [2]
  $ raylab slurm sky.scene -o sky.png --bands 4 --size 6x10 --grey -j 2
  raylab: warning: --size 6x10 distorts the picture, which looks 2 times as wide as it should; 6x20 would not
  raylab: $TESTCASE_ROOT/sky.slurm/picture.scene is of another job, or was edited. Run $TESTCASE_ROOT/sky.slurm/submit to go on with that job, or remove $TESTCASE_ROOT/sky.slurm to start anew
  [2]

Wrong
-----

  $ wrong () { raylab slurm "$@" 2>&1 | sed '/^Usage:/,$d'; }
  $ wrong sky.scene
  raylab: required option --output is missing
  $ wrong sky.scene -o a.bmp
  raylab: required option --bands is missing
  $ wrong sky.scene -o a.bmp --bands 0
  raylab: option '--bands': '0' is not a number of bands
  $ wrong sky.scene -o a.bmp --bands 11
  raylab: option --bands: the picture has only 10 rows
  $ wrong sky.scene -o - --bands 2
  raylab: option -o: a job has no standard output for a picture; name a file
  $ wrong sky.scene -o a.gif --bands 2
  raylab: a.gif: there is no picture format '.gif'; use .bmp, .png or .ppm
  $ wrong sky.scene -o sky.scene --bands 2
  raylab: sky.scene is the scene; the picture would replace it
  $ wrong sky.scene -o tools --bands 2
  raylab: tools: is a directory
  $ wrong sky.scene -o missing/a.bmp --bands 2
  raylab: missing/a.bmp: No such file or directory
  $ wrong sky.scene -o a.bmp --bands 2 --size 40000x40000
  raylab: a BMP of 40000 x 40000 pixels is too large: no BMP has more than 4 GiB. Use .png or .ppm
  $ wrong sky.scene -o a.ppm --bands 2 --size 60000x60000
  raylab: the bands are too large, make more of them: a picture of 60000 x 30000 pixels would take 5.0 GiB of memory; the limit is 4 GiB
  $ echo 'imWidth x' > broken.scene
  $ raylab slurm broken.scene -o a.bmp --bands 2
  broken.scene:1:9: error: 'x' is not a number
      1 | imWidth x
        |         ^
  expected the width of the picture in pixels after imWidth, such as 640.
  [1]
  $ ls -d *.slurm
  many.slurm
  new.slurm
  sky.slurm

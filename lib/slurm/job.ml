type t = {
  raylab : string;
  view : string list;
  height : int;
  bands : int;
  cores : int;
  out : string;
}

let scene = "picture.scene"
let folders = [ "bands"; "log" ]
let submit = "submit"

(* What stands in a line for Slurm must need no quotes. *)
let name { out; _ } =
  let plain = function
    | ('a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '.' | '-' | '_') as c -> c
    | _ -> '_'
  in
  let name = String.map plain Filename.(remove_extension (basename out)) in
  "raylab-" ^ String.sub name 0 (Int.min 40 (String.length name))

let quoted = List.map Filename.quote

let bands job =
  Printf.sprintf
    {|#!/bin/bash
# Renders the bands of a picture, one a task. Written by raylab slurm; edit it
# as you like. A band appears whole or not at all, and one that is there is left
# alone, so that tasks may run twice.
#SBATCH --job-name=%s
#SBATCH --array=1-%d
#SBATCH --cpus-per-task=%d
#SBATCH --output=log/band-%%a.txt
#SBATCH --open-mode=append
#SBATCH --requeue

raylab=%s
if [ -n "$RAYLAB" ]; then raylab=$RAYLAB; fi
view=(%s)
height=%d bands=%d

band=$SLURM_ARRAY_TASK_ID
part=bands/$band.ppm
if [ -e "$part" ]; then exit; fi
first=$(((band - 1) * height / bands))
last=$((band * height / bands - 1))

# A lost node is for Slurm to replace (--requeue above). A failure is tried
# again here, unless it is one of the scene (1) or of the command line (124).
for try in 1 2 3; do
  "$raylab" render %s "${view[@]}" --rows "$first-$last" \
    -j "${SLURM_CPUS_PER_TASK:-1}" -q -o "$part"
  status=$?
  if [ "$status" = 0 ]; then exit; fi
  echo "rows $first-$last, try $try: exit status $status" >&2
  if [ "$status" = 1 ] || [ "$status" = 124 ]; then break; fi
  sleep "$try"
done
exit "$status"
|}
    (name job) job.bands job.cores
    (Filename.quote job.raylab)
    (String.concat " " (quoted job.view))
    job.height job.bands scene

let join job =
  Printf.sprintf
    {|#!/bin/bash
# Joins the bands of a picture. Written by raylab slurm; edit it as you like.
#SBATCH --job-name=%s-join
#SBATCH --output=log/join.txt
#SBATCH --open-mode=append
#SBATCH --requeue

raylab=%s
if [ -n "$RAYLAB" ]; then raylab=$RAYLAB; fi

"$raylab" join bands -q -o %s
|}
    (name job)
    (Filename.quote job.raylab)
    (Filename.quote job.out)

let submit_text job =
  Printf.sprintf
    {|#!/bin/bash
# Submits the bands that are not there yet, and the job that joins them. Written
# by raylab slurm; run it again when something has failed.
cd -- "$(dirname -- "$0")" || exit
bands=%d

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
  job=${job%%%%;*} # the name of a cluster may follow
  say "job $job renders bands $missing"
  # after failures as well: it says which rows are missing
  after=(--dependency="afterany:$job")
fi
job=$(sbatch --parsable "${after[@]}" join.sbatch) || exit
say "job ${job%%%%;*} joins them"
|}
    job.bands

let writers =
  [ ("bands.sbatch", bands); ("join.sbatch", join); (submit, submit_text) ]

let names = List.map fst writers
let scripts job = List.map (fun (name, write) -> (name, write job)) writers

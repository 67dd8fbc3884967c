# A Slurm of two nodes on this machine, there only for the test: daemons that need
# no systemd, with a folder, keys, sockets and ports of their own. Read by the cram
# test. Nothing waits for a fixed time: [until_ok] polls.

PATH=$PATH:/usr/sbin:/sbin # where Debian has the daemons
gave_up=
for tool in munged slurmctld slurmd sbatch scontrol; do
  command -v $tool >/dev/null || {
    echo "$tool is missing. What the tests need is installed by bin/setup --test on"
    echo "Debian and Ubuntu, and elsewhere by the system's packages of Slurm and munge."
    gave_up=yes
  }
done

# In /tmp: the path of a Unix socket has at most 107 bytes, and dune's are long.
top=$(mktemp -d /tmp/raylab-slurm-XXXXXX)
export SLURM_CONF=$top/slurm.conf

# Whatever belongs to this Slurm, daemon or job, has the name of its file in its
# environment, or a file of its folder open.
members() (
  unset SLURM_CONF # or what follows would be members as well
  {
    grep -slF "$top/slurm.conf" /proc/[0-9]*/environ
    find /proc/[0-9]*/fd -lname "$top/*" 2>/dev/null
  } | cut -d / -f 3 | sort -u
)
stop_cluster() {
  trap - EXIT
  while pids=$(members) && [ -n "$pids" ]; do
    kill -9 $pids 2>/dev/null
    sleep 0.05
  done
  rm -rf "$top"
}
trap stop_cluster EXIT
trap 'exit 1' HUP INT TERM

# [until_ok COMMAND...] repeats COMMAND until it succeeds, for a minute. Once it has
# waited in vain, and shown what the daemons said, it gives up at once.
until_ok() {
  local tries=0
  until "$@" >/dev/null 2>&1; do
    [ -z "$gave_up" ] || return 1
    tries=$((tries + 1))
    [ $tries -lt 600 ] || {
      gave_up=yes
      echo "waited in vain for: $*"
      squeue
      sinfo
      tail -n 30 "$top"/*.log
    }
    sleep 0.1
  done
}

# [free_ports N] prints N ports that nobody listens on.
free_ports() {
  bash -c '
    port=$((20000 + RANDOM % 10000)) left=$1
    while [ $left -gt 0 ]; do
      port=$((port + 1))
      if ! (: <"/dev/tcp/127.0.0.1/$port") 2>/dev/null; then
        echo $port
        left=$((left - 1))
      fi
    done' - "$1"
}

configure() {
  host=$(uname -n | cut -d . -f 1) me=$(id -un)
  cat >"$SLURM_CONF" <<END
ClusterName=raylab
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$1
SlurmUser=$me
SlurmdUser=$me
AuthType=auth/munge
# a job that is queued again waits until credentials have expired
AuthInfo=socket=$top/munge.socket,cred_expire=5
StateSaveLocation=$top/state
SlurmdSpoolDir=$top/%n
SlurmctldPidFile=$top/slurmctld.pid
SlurmdPidFile=$top/%n.pid
SlurmctldLogFile=$top/slurmctld.log
SlurmdLogFile=$top/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,bf_interval=1
ReturnToService=0
# the scripts ask for it themselves
JobRequeue=0
KillWait=1
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$2 CPUs=2
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$3 CPUs=2
PartitionName=all Nodes=n1,n2 Default=YES
END
  # No control groups: a container may have none. Debian 12's Slurm cannot do
  # without a plugin for them, and this one asks for nothing.
  case $(slurmd -V) in
    *' 22.'*) echo CgroupPlugin=cgroup/v1 ;;
    *) echo CgroupPlugin=disabled ;;
  esac >"$top/cgroup.conf"
}

start_munge() {
  head -c 1024 /dev/urandom >"$top/munge.key"
  chmod 600 "$top/munge.key"
  munged --foreground --key-file="$top/munge.key" --socket="$top/munge.socket" \
    --pid-file="$top/munged.pid" --log-file="$top/munged.log" \
    --seed-file="$top/munged.seed" >"$top/munged.err.log" 2>&1 &
}

start_node() { slurmd -D -N "$1" >"$top/$1.err.log" 2>&1 & }
are_idle() { [ "$(sinfo -h -t idle -o %D)" = 2 ]; }

start_cluster() {
  [ -z "$gave_up" ] || return 1
  chmod 711 "$top" # munge asks that all may go to its socket
  mkdir "$top/state" "$top/n1" "$top/n2"
  configure $(free_ports 3)
  start_munge
  until_ok test -S "$top/munge.socket"
  slurmctld -D >"$top/slurmctld.err.log" 2>&1 &
  start_node n1
  start_node n2
  until_ok are_idle
}

# [is_over] is whether no job is waiting or running.
is_over() { [ -z "$(squeue -h 2>&1)" ]; }
over() { until_ok is_over; }

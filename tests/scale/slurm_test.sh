#!/usr/bin/env bash
# slurm_test.sh FELTLINE: the recipe with Slurm, on two nodes, one of which is killed in the middle. The
# nodes are two daemons on this machine, with their own controller and MUNGE key in the test's folder.
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")  # before the working folder changes
. "$here/../cli/helpers.sh"
. "$here/helpers.sh"
[ "$(id -u)" = 0 ] || { echo "skipped: the daemons of Slurm need root"; exit 77; }
need munge command -v munged
need slurmctld command -v slurmctld
need slurmd command -v slurmd
need slurm-client command -v sbatch

configure_slurm() {
  local host port=$((20000 + $$ % 10000))
  host=$(hostname -s)
  mkdir state
  (umask 077 && head -c 1024 /dev/urandom >munge.key)
  cat >slurm.conf <<END
ClusterName=feltline
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
AuthType=auth/munge
CredType=cred/munge
# A task that is run again waits until its credential has expired, 120 s by default.
AuthInfo=socket=$work/munge.socket,cred_expire=5
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool-%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdTimeout=5
SchedulerParameters=bf_interval=2
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$((port + 1))-$((port + 2))] CPUs=1
PartitionName=all Nodes=n[1-2] Default=YES State=UP
END
  export SLURM_CONF=$work/slurm.conf
}

stop_slurm() {
  mapfile -t left < <(for name in control n1 n2; do processes_with "FELT_MACHINE=$work/$name"; done
    processes_with "FELTLINE=$work/slow_feltline" "SLURM_CONF=$work/slurm.conf")
  [ ${#left[@]} = 0 ] || kill -KILL "${left[@]}" 2>/dev/null
  rm -rf "$work"
}

# on MACHINE COMMAND...: starts a daemon, which gets the name in its environment.
on() { FELT_MACHINE=$work/$1 "${@:2}" >>starting 2>&1; }

# Starts the daemons, or skips the test if they do not start here (no MUNGE, or a locked-down container).
start_slurm() {
  local tries
  on control munged --force --socket="$work/munge.socket" --key-file="$work/munge.key" \
    --pid-file="$work/munged.pid" --log-file="$work/munged.log" --seed-file="$work/munged.seed" &&
    on control slurmctld -c && on n1 slurmd -N n1 && on n2 slurmd -N n2
  for ((tries = 0; tries < 60; ++tries)); do
    [ "$(sinfo -h -o %D -t idle 2>/dev/null)" != 2 ] || return 0
    sleep 0.5
  done
  echo "skipped: Slurm does not start here: $(tail -qn 3 starting munged.log slurmctld.log 2>/dev/null)"
  exit 77
}

make_shards 4000
slow_down
configure_slurm
trap stop_slurm EXIT
start_slurm

# Kills the daemon of the node, and those of its tasks before they can report that the tasks have ended.
kill_first() {
  local daemons
  # shellcheck disable=SC2154  # kill_in_the_middle sets victims
  mapfile -t daemons < <(
    processes_with "FELT_MACHINE=$work/n1"
    ps -eo pid=,ppid=,comm= | awk -v victims=" ${victims[*]} " '
      index(victims, " " $1 " ") { parents[$2] }
      $3 == "slurmstepd" { steps[$1] }
      END { for (step in steps) if (step in parents) print step }')
  kill -KILL "${daemons[@]}"
}

job=$("$recipes/with_slurm.sh" shards results 4) || fail "sbatch failed"
kill_in_the_middle results "FELTLINE=$FELTLINE" SLURMD_NODENAME=n1
was_interrupted results
before=$(count_done results)

for ((tries = 0; tries < 240; ++tries)); do
  [ -n "$(squeue -h -j "$job" 2>/dev/null)" ] || break
  sleep 0.5
done
is_whole results
has slurmctld.log "due to failure of node n1"

sinfo -h -N -o '%N %T' >nodes
has nodes "n1 down"
has nodes "n2 idle"
echo "node n1 killed after $before shards; $(grep -c Requeuing slurmctld.log) tasks run again"

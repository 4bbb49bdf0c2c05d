#!/usr/bin/env bash
# with_slurm.sh SHARDS RESULTS TASKS [OPTION...]: submits an array job of TASKS tasks to Slurm, and prints
# the number of the job. All nodes must share both folders. SBATCH_* variables set the partition and more.
#
# Task i fits the shards i, i + TASKS, i + 2 TASKS, ... If a node dies, Slurm runs its tasks again on other
# nodes (--requeue), and a task skips the shards that are finished. When the job has ended, run
# check_results.sh; if a shard is not finished, submit the same command again.
set -euo pipefail
if [ -z "${SLURM_ARRAY_TASK_ID:-}" ]; then  # on the machine that submits
  mkdir -p "$2"
  printf -v command '%q ' bash "$(readlink -f "${BASH_SOURCE[0]}")" "$(readlink -f "$1")" \
    "$(readlink -f "$2")" "${@:3}"
  exec sbatch --parsable --job-name=feltline --array="0-$(($3 - 1))" --ntasks=1 --cpus-per-task=1 \
    --requeue --open-mode=append --output="$(readlink -f "$2")/task-%a.log" --wrap="exec $command"
fi

shards=$1 results=$2 tasks=$3
shift 3
mapfile -t all < <(find "$shards" -name '*.ndjson' | LC_ALL=C sort)
status=0
for ((i = SLURM_ARRAY_TASK_ID; i < ${#all[@]}; i += tasks)); do
  "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/fit_shard.sh" "${all[i]}" "$results" "$@" || status=1
done
exit $status

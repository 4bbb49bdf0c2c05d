#!/usr/bin/env bash
# with_parallel.sh SHARDS RESULTS JOBS [OPTION...]: fits all shards with GNU parallel, JOBS at a time.
#
# After a kill, run the same command again: fit_shard.sh skips the shards that are finished. A shard that fails
# is tried three times. To use several machines that share both folders, set PARALLEL="--sshloginfile HOSTS".
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
mkdir -p "$2"
shards=$(readlink -f "$1") results=$(readlink -f "$2") jobs=$3
shift 3
find "$shards" -name '*.ndjson' | LC_ALL=C sort |
  parallel --quote --jobs "$jobs" --joblog "$results/joblog" --retries 3 \
    "$here/fit_shard.sh" {} "$results" "$@" || echo "with_parallel.sh: some shards failed" >&2
"$here/check_results.sh" "$shards" "$results"

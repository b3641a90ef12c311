#!/usr/bin/env bash
# One fold of `pathlight reproduce` as a job of an array: 0 to 9 are the folds of the setup within, 10 to 19 of cross. Run
# it from the root of the repository, after `make build` and `pathlight reproduce --only data`. Arguments are passed on.
#
#   sbatch --array=0-19 --cpus-per-task=2 results/array.sh
#   seq 0 19 | RAYON_NUM_THREADS=2 xargs -P 4 -I{} env SLURM_ARRAY_TASK_ID={} results/array.sh  # without a scheduler
set -euo pipefail
index=${SLURM_ARRAY_TASK_ID:-}
if ! [[ $index =~ ^0*(1?[0-9])$ ]]; then
    echo "error: SLURM_ARRAY_TASK_ID is '$index': set it to 0 to 19" >&2
    exit 2
fi
index=${BASH_REMATCH[1]}
setups=(within cross)
# As many threads as the scheduler has allocated cores; 0 means all cores.
export RAYON_NUM_THREADS=${SLURM_CPUS_PER_TASK:-${RAYON_NUM_THREADS:-0}}
exec "${PATHLIGHT:-target/release/pathlight}" reproduce --only folds \
    --setup "${setups[index / 10]}" --fold $((index % 10)) "$@"

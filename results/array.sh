#!/usr/bin/env bash
# One row of `pathlight table` as a job of an array: 0 to 9 are the folds within templates, 10 to 19 across. Run it
# from the root of the repository, after `make build` and `pathlight table --only data`. More arguments are passed on.
#
#   sbatch --array=0-19 --cpus-per-task=2 results/array.sh
#   seq 0 19 | RAYON_NUM_THREADS=2 xargs -P 4 -I{} env SLURM_ARRAY_TASK_ID={} results/array.sh  # without a scheduler
set -euo pipefail
index=${SLURM_ARRAY_TASK_ID:-}
if ! [[ $index =~ ^0*(1?[0-9])$ ]]; then
    echo "error: SLURM_ARRAY_TASK_ID is '$index': give the row, 0 to 19" >&2
    exit 2
fi
index=${BASH_REMATCH[1]}
setups=(within cross)
# As many threads as the scheduler has given cores; 0 is all.
export RAYON_NUM_THREADS=${SLURM_CPUS_PER_TASK:-${RAYON_NUM_THREADS:-0}}
exec "${PATHLIGHT:-target/release/pathlight}" table --only rows \
    --setup "${setups[index / 10]}" --fold $((index % 10)) "$@"

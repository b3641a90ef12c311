#!/usr/bin/env bash
# One row of `pathlight table` as a job of an array: 0 to 9 are the folds within templates, 10 to 19 across. Run it
# from the root of the repository, the data made (`pathlight table --only data`). Further arguments are passed on.
#
#   sbatch --array=0-19 --cpus-per-task=2 results/array.sh
#   seq 0 19 | xargs -P 4 -I{} env SLURM_ARRAY_TASK_ID={} results/array.sh     # without a scheduler
set -euo pipefail
index=${SLURM_ARRAY_TASK_ID:?is not set: give the row, 0 to 19}
setups=(within cross)
# As many threads as the scheduler has given cores.
export RAYON_NUM_THREADS=${SLURM_CPUS_PER_TASK:-${RAYON_NUM_THREADS:-0}}
exec "${PATHLIGHT:-target/release/pathlight}" table --only rows \
    --setup "${setups[index / 10]}" --fold $((index % 10)) "$@"

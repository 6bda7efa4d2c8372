#!/bin/bash
# One worker and one rank of the program on each node. Not tried: Slurm was not within reach.
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=1
#SBATCH --exclusive
#SBATCH --time=01:00:00
set -eu
job=$SLURM_JOB_ID
export GLURAY_RUNTIME=/tmp/gluray-$SLURM_JOB_ID  # local to each node; gluray makes it

# The step's SLURM_CPUS_PER_TASK is the number of tracing threads.
srun --mpi=pmix --overlap --ntasks-per-node=1 --cpus-per-task="$SLURM_CPUS_ON_NODE" gluray-worker --job "$job" &
workers=$!
trap 'kill $workers 2>/dev/null || true' EXIT

# Exit code 0 or 1: the job answers.
until gluray doctor --job "$job" >/dev/null || [ $? = 1 ]; do
  kill -0 $workers || exit 1
  sleep 1
done

# The program's ranks leave tracing to the workers. The report has a row for each rank.
srun --mpi=pmix --overlap --ntasks-per-node=1 --cpu-bind=none \
  gluray --workers "$job" --report "report-$job.json" --set ao=on --set shadows=on -- "$@"

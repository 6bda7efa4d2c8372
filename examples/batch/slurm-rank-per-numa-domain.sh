#!/bin/bash
# One worker and one rank of the program on each NUMA domain. Not tried: Slurm was not within reach.
# Replace 8 and 16 by the domains of a node and the cores of a domain (lscpu).
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=8
#SBATCH --cpus-per-task=16
#SBATCH --exclusive
#SBATCH --time=01:00:00
set -eu
job=$SLURM_JOB_ID
export GLURAY_RUNTIME=/tmp/gluray-$SLURM_JOB_ID  # local to each node; gluray makes it

# Each worker is bound to its domain, so that its threads find its geometry in near memory. Several workers on
# a node keep a copy of the geometry each.
srun --mpi=pmix --overlap --ntasks-per-node=8 --cpus-per-task=16 --cpu-bind=ldoms --mem-bind=local \
  gluray-worker --job "$job" &
workers=$!
trap 'kill $workers 2>/dev/null || true' EXIT

# Exit code 0 or 1: the job answers.
until gluray doctor --job "$job" >/dev/null || [ $? = 1 ]; do
  kill -0 $workers || exit 1
  sleep 1
done

# Rank n of a node connects to worker n of the node.
srun --mpi=pmix --overlap --ntasks-per-node=8 --cpus-per-task=16 --cpu-bind=ldoms \
  gluray --workers "$job" --report "report-$job.json" --set ao=on --set shadows=on -- "$@"

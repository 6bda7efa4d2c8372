#!/bin/bash
# Workers and program in containers of one image, with Slurm. Not tried: neither Slurm nor Apptainer was
# within reach. IMAGE: an image with GLuRay (packaging/recipes/apptainer) and the program. Slurm's MPI must
# support the MPI of the image.
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=1
#SBATCH --exclusive
#SBATCH --time=01:00:00
set -eu
image=${IMAGE:-gluray.sif} job=$SLURM_JOB_ID
# Containers share /tmp of the host, but not /run/user.
export GLURAY_RUNTIME=/tmp/gluray-$SLURM_JOB_ID

# The CPU quota of a container bounds the number of threads; gluray doctor in the container prints it.
srun --mpi=pmix --overlap --ntasks-per-node=1 --cpus-per-task="$SLURM_CPUS_ON_NODE" \
  apptainer exec "$image" gluray-worker --job "$job" &
workers=$!
trap 'kill $workers 2>/dev/null || true' EXIT

# Exit code 0 or 1: the job answers.
until apptainer exec "$image" gluray doctor --job "$job" >/dev/null || [ $? = 1 ]; do
  kill -0 $workers || exit 1
  sleep 1
done

srun --mpi=pmix --overlap --ntasks-per-node=1 --cpu-bind=none apptainer exec "$image" \
  gluray --workers "$job" --report "report-$job.json" --set ao=on --set shadows=on -- "$@"

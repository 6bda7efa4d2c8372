#!/bin/bash
# Workers and a program of MPICH. Tried with MPICH 4.0.2 on one machine, with two ranks of a small program.
# RANKS: of the program, WORKERS: of the job; HOSTS: options of mpiexec such as "-f hosts".
set -eu
ranks=${RANKS:-4} workers=${WORKERS:-1} job=batch-$$
mpiexec=${MPIEXEC:-mpiexec}  # Debian: mpiexec.hydra
read -ra hosts <<<"${HOSTS:-}"

# -ppn 1: one worker on each host. Ranks of MPICH are not bound unless -bind-to asks for it.
"$mpiexec" "${hosts[@]}" -n "$workers" -ppn 1 gluray-worker --mpi mpich --job "$job" &
running=$!
trap 'kill $running 2>/dev/null || true; wait' EXIT

# Exit code 0 or 1: the job answers.
until gluray doctor --job "$job" >/dev/null || [ $? = 1 ]; do
  kill -0 $running || exit 1
  sleep 1
done

"$mpiexec" "${hosts[@]}" -n "$ranks" \
  gluray --workers "$job" --report "report-$job.json" --set ao=on --set shadows=on -- "$@"

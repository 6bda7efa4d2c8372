#!/bin/bash
# Workers and a program of Open MPI. Tried with Open MPI 4.1.4 on one machine, with two ranks of pvbatch.
# RANKS: of the program, WORKERS: of the job; HOSTS: options of mpirun such as "--hostfile hosts".
set -eu
ranks=${RANKS:-4} workers=${WORKERS:-1} job=batch-$$
read -ra hosts <<<"${HOSTS:-}"

# --bind-to none: the workers of a host share its cores.
mpirun "${hosts[@]}" -n "$workers" --map-by node --bind-to none gluray-worker --job "$job" &
running=$!
trap 'kill $running 2>/dev/null || true; wait' EXIT

# Exit code 0 or 1: the job answers.
until gluray doctor --job "$job" >/dev/null || [ $? = 1 ]; do
  kill -0 $running || exit 1
  sleep 1
done

mpirun "${hosts[@]}" -n "$ranks" --bind-to none \
  gluray --workers "$job" --report "report-$job.json" --set ao=on --set shadows=on -- "$@"

/* gluray-worker: traces images for programs whose setting `workers` names its job. Started once, or by mpirun
   or srun as a job of many ranks. The code is part of the engine's library, which has all that it needs
   (docs/adr/0109); the program reads its options. */
#pragma once
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct GlurayWorkerOptions {
  const char* job;
  const char* mpi; /* "openmpi", "mpich", "none", a library, or "auto": that of the launcher */
  int threads;     /* of each rank; 0: the cores of the machine, shared by its ranks */
  uint64_t memory; /* bytes of each rank; 0: most of the free memory */
  int quiet;       /* errors only */
} GlurayWorkerOptions;

/* Works until a signal ends it. `argc` and `argv` are main()'s, for MPI. Returns the program's exit code. */
int glurayWorker(const GlurayWorkerOptions* options, int argc, char** argv);

#ifdef __cplusplus
}
#endif

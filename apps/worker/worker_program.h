// gluray-worker: traces images for programs whose setting `workers` names its job. Started once, or by mpirun
// or srun as a job of many ranks. The code is part of the engine's library, which has all that it needs
// (docs/adr/0109).
#pragma once

/// The program's main(). Returns its exit code.
extern "C" int glurayWorker(int argc, char** argv);

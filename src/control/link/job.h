// The position of this process in an MPI job, from the variables that MPI's launchers set: Open MPI, PMIx,
// MVAPICH, MPICH (Hydra) and Slurm. Any thread.
#pragma once
#include <functional>
#include <string>

namespace gluray::control {

struct Job {
  int rank = 0, ranks = 1;
  std::string name;  // the same for all ranks of the job; empty: no job
};

/// Returns the value of a variable; empty if it is not set.
using AskVariable = std::function<std::string(const char* name)>;

/// `launcher`: text that identifies this process's launcher, such as "node7 4100", used if no variable names
/// the job.
Job jobOf(const AskVariable& variable, const std::string& launcher);

/// The job of this process.
Job jobOfThisProcess();

}  // namespace gluray::control

// How many threads the process may use, and how many it should: limits of the system, and what the launchers
// of batch jobs say. Any thread, while no other thread sets environment variables.
#pragma once
#include <functional>
#include <string>

namespace gluray {

/// What the choice depends on. Tests make their own.
struct Surroundings {
  std::string root;                                       // folder of proc and sys; empty: "/"
  std::function<std::string(const char* name)> variable;  // of the environment; empty: not set
  int hostCores = 1;                                      // online
  int affinity = 1;                                       // of these, those that the process may run on
  int ranksHere = 1;                                      // MPI processes on this host
};

/// Those of this process. `ranksHere` from variables of Open MPI, MPICH and derivatives, MVAPICH.
Surroundings surroundingsOfThisProcess();

struct ThreadCount {
  int threads = 1;
  std::string because;   // "SLURM_CPUS_PER_TASK", "CPU quota of the cgroup: 2.5 cores"
  bool isLimit = false;  // of the system: more threads would not run at the same time
};

/// CPUs that the cgroups of the process grant, the smallest of all levels: cpu.max (version 2) or
/// cpu.cfs_quota_us (version 1). 0: no limit.
double coresOfQuota(const Surroundings& here);

/// The most threads that run at the same time: the smaller one of quota, rounded up, and affinity.
ThreadCount mostThreads(const Surroundings& here);

/// The number of threads. `wanted`: the setting; 0: not set. The first of these that says something, but at
/// most mostThreads(): `wanted`, SLURM_CPUS_PER_TASK, OMP_NUM_THREADS, and mostThreads() itself, which the
/// ranks of a host share unless they are bound to cores of their own.
ThreadCount chosenThreads(int wanted, const Surroundings& here);

/// The same for this process. Limits and variables are read at the first call.
int mostThreadsHere();
int chosenThreadsHere();  // without the setting

}  // namespace gluray

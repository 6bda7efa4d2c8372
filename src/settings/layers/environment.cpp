#include "settings/layers/settings_layers.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace gluray {
namespace {

/// Number of MPI processes on this host, from variables of Open MPI, MPICH and derivatives, MVAPICH; 1
/// without MPI.
int localRanks() {
  for (const char* name : {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", "MV2_COMM_WORLD_LOCAL_SIZE"})
    if (const char* value = std::getenv(name)) return std::max(std::atoi(value), 1);
  return 1;
}

int coresAllowed() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

}  // namespace

int threadsOfRank(int cores, int allowed, int ranks) {
  // A launcher that binds ranks to cores has already divided the cores.
  if (ranks <= 1 || allowed < cores) return 0;
  return std::max(1, cores / ranks);
}

int threadsOfThisRank() {
  return threadsOfRank(static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN)), coresAllowed(), localRanks());
}

Session sessionFromEnvironment(const Complain& complain) {
  Session session = readLayers(sourcesOfProcess(), complain).session;
  if (session.settings.threads == 0) session.settings.threads = threadsOfThisRank();
  return session;
}

}  // namespace gluray

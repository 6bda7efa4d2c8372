// Which MPI a worker speaks: the one whose launcher started it.
#pragma once
#include "cluster/ranks/ranks.h"

#include <functional>
#include <memory>
#include <string>

namespace gluray::worker {

/// The name of an implementation, "openmpi" or "mpich"; "none": no launcher of MPI started this process.
std::string launchersMpi(const std::function<std::string(const char*)>& variable);

/// Starts MPI. `name`: as above, or the path of a library. Null, and one line in `why`: it cannot.
std::unique_ptr<cluster::Ranks> startRanks(const std::string& name, int* argc, char*** argv,
                                           std::string& why);

}  // namespace gluray::worker

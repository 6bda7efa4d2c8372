// Interface of the MPI plug-ins that gluray-worker loads: one library for each MPI implementation, because
// their binary interfaces differ.
#pragma once
#include "cluster/ranks/ranks.h"

namespace gluray::cluster {

/// Version of GLuRay that the library was built with; it must equal the worker's.
using MpiPluginVersion = const char* (*)();
constexpr const char* kMpiPluginVersion = "glurayMpiPluginVersion";

/// Starts MPI, once in a process. Deleting the result ends MPI. Returns null if MPI cannot start or is too
/// old, with one line of at most `room` characters in `why`.
using MakeMpiRanks = Ranks* (*)(int* argc, char*** argv, char* why, size_t room);
constexpr const char* kMakeMpiRanks = "glurayMakeMpiRanks";

}  // namespace gluray::cluster

// What gluray-worker loads to speak MPI: one library for each implementation of MPI, because their binary
// interfaces differ.
#pragma once
#include "cluster/ranks/ranks.h"

namespace gluray::cluster {

/// Version of GLuRay that the library was built with; the worker's own, or it is not used.
using MpiPluginVersion = const char* (*)();
constexpr const char* kMpiPluginVersion = "glurayMpiPluginVersion";

/// Starts MPI, once in a process. Deleting the result ends it. Null, and in `why` one line, of `room`
/// characters at most: MPI cannot start, or is too old.
using MakeMpiRanks = Ranks* (*)(int* argc, char*** argv, char* why, size_t room);
constexpr const char* kMakeMpiRanks = "glurayMakeMpiRanks";

}  // namespace gluray::cluster

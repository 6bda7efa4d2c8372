// Start times of processes, from /proc. Any thread.
#pragma once
#include <sys/types.h>

#include <cstdint>

namespace gluray::control {

/// Data of a process from the kernel (proc(5), stat).
struct ProcessStat {
  char name[16] = {};    // of the executable, truncated
  pid_t parent = 0;      // 0: the process does not exist
  uint64_t started = 0;  // clock ticks since boot
};
ProcessStat statOf(pid_t process) noexcept;

/// Start time of this process in seconds since 1970; 0 if unknown.
double beginOfProcess() noexcept;

}  // namespace gluray::control

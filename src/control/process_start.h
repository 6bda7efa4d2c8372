// When processes began, from /proc. Any thread.
#pragma once
#include <sys/types.h>

#include <cstdint>

namespace gluray::control {

/// What the kernel says of a process (proc(5), stat).
struct ProcessStat {
  char name[16] = {};    // of the executable, cut
  pid_t parent = 0;      // 0: the process is gone
  uint64_t started = 0;  // clock ticks since boot
};
ProcessStat statOf(pid_t process) noexcept;

/// When this process began, seconds since 1970; 0: unknown.
double beginOfProcess() noexcept;

}  // namespace gluray::control

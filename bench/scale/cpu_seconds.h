// CPU time of threads and processes, from Linux's scheduler. Any thread.
#pragma once
#include <sys/types.h>

namespace gluray::bench {

/// Seconds that the calling thread has run; that all threads of this process have run.
double threadCpuSeconds();
double processCpuSeconds();
/// What one call of threadCpuSeconds() adds to the time between two.
double threadCpuClockSeconds();

/// Seconds that the threads of another process have run: its main thread, and the others that still live.
struct CpuSeconds {
  double main = 0, others = 0;
};
/// Throws std::runtime_error where there is no such process.
CpuSeconds cpuSecondsOf(pid_t process);

}  // namespace gluray::bench

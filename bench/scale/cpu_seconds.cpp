#include "bench/scale/cpu_seconds.h"

#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace gluray::bench {
namespace {

double secondsOf(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double threadCpuSeconds() { return secondsOf(CLOCK_THREAD_CPUTIME_ID); }
double threadCpuClockSeconds() {
  constexpr int kCalls = 1000;
  const double start = threadCpuSeconds();
  for (int i = 0; i < kCalls; ++i) threadCpuSeconds();
  return (threadCpuSeconds() - start) / kCalls;
}
double processCpuSeconds() { return secondsOf(CLOCK_PROCESS_CPUTIME_ID); }

CpuSeconds cpuSecondsOf(pid_t process) {
  const std::string number = std::to_string(process);
  std::error_code error;
  CpuSeconds seconds;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/" + number + "/task", error)) {
    double nanoseconds = 0;  // the first number of schedstat
    if (!(std::ifstream(thread.path() / "schedstat") >> nanoseconds)) continue;
    (thread.path().filename() == number ? seconds.main : seconds.others) += 1e-9 * nanoseconds;
  }
  if (error || seconds.main == 0) throw std::runtime_error("no process " + number);
  return seconds;
}

}  // namespace gluray::bench

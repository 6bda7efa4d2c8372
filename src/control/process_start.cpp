#include "control/process_start.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <ctime>

namespace gluray::control {
namespace {

double secondsOf(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

ProcessStat statOf(pid_t process) noexcept {
  ProcessStat found;
  char path[32], text[1024];
  std::snprintf(path, sizeof path, "/proc/%d/stat", static_cast<int>(process));
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return found;
  const ssize_t size = read(file, text, sizeof text - 1);
  close(file);
  text[std::max<ssize_t>(size, 0)] = '\0';
  // The name is in parentheses and may contain anything.
  const char* const begin = std::strchr(text, '(');
  const char* const end = std::strrchr(text, ')');
  if (!begin || !end || end < begin) return found;
  std::copy_n(begin + 1, std::min<size_t>(end - begin - 1, sizeof found.name - 1), found.name);
  int parent = 0;
  uint64_t started = 0;
  // Fields 3, 4, then 17 that are not needed, then 22.
  if (std::sscanf(end + 1,
                  " %*c %d %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %" SCNu64,
                  &parent, &started) == 2)
    found.parent = parent, found.started = started;
  return found;
}

double beginOfProcess() noexcept {
  const uint64_t started = statOf(getpid()).started;
  if (started == 0) return 0;
  return secondsOf(CLOCK_REALTIME) - secondsOf(CLOCK_BOOTTIME) +
         static_cast<double>(started) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace gluray::control

// Resident memory of this process. Any thread.
#pragma once
#include <unistd.h>

#include <cstdint>
#include <fstream>

namespace gluray {

/// Bytes; 0: unknown, because there is no /proc.
inline uint64_t residentBytes() {
  std::ifstream file("/proc/self/statm");
  uint64_t all = 0, resident = 0;
  if (!(file >> all >> resident)) return 0;
  return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace gluray

// TAP interfaces in other network namespaces.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <cstdint>
#include <string>
#include <vector>

namespace network {

/// Makes an interface for each "NAME:PROCESS". It vanishes with this object.
class Taps {
 public:
  /// Throws std::runtime_error where the kernel refuses.
  explicit Taps(const std::vector<std::string>& names);
  ~Taps();
  Taps(const Taps&) = delete;
  Taps& operator=(const Taps&) = delete;
  size_t count() const { return files_.size(); }
  /// A descriptor that reads and writes whole Ethernet frames, and does not block.
  int at(size_t number) const { return files_[number]; }

 private:
  std::vector<int> files_;
};

/// Nanoseconds of the steady clock.
int64_t now();
/// As ppoll() until that time of the steady clock; negative: without end.
int waitUntil(std::vector<pollfd>& waits, int64_t time);

}  // namespace network

// The Embree device: errors, memory accounting, capabilities. Made on first use by World; any thread may
// query it.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

struct RTCDeviceTy;

namespace gluray::accel {

/// Owns an RTCDevice that prints nothing, reads no configuration file, and counts the memory it holds.
class Device {
 public:
  /// Throws Error where Embree cannot start.
  Device();
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  RTCDeviceTy* handle() const { return device_; }
  /// Rays a packet that the processor handles natively: 16, 8 or 4.
  int packetWidth() const { return packetWidth_; }
  /// Embree's version, "3.13.5".
  std::string version() const;
  /// Bytes that Embree holds for acceleration structures now.
  static size_t bytes();
  /// Those of them that were not asked for inside a BehindScope.
  static size_t bytesOfFrames();
  /// Throws Error("WHAT: reason") if a call of this thread failed since the last check.
  void check(std::string_view what) const;

 private:
  RTCDeviceTy* device_ = nullptr;
  int packetWidth_ = 4;
};

/// For tests: `after` commits of acceleration structures succeed, then `count` fail as if memory had run out.
void failNextCommits(int count, int after = 0);
/// Failures asked for that have not come yet.
int commitsStillToFail();

/// While it lives, what its thread allocates is counted apart.
class BehindScope {
 public:
  BehindScope();
  ~BehindScope();
  BehindScope(const BehindScope&) = delete;
  BehindScope& operator=(const BehindScope&) = delete;
  /// Bytes that this thread allocated in this scope and has not freed.
  size_t bytes() const;
};

/// Marks the time in which a commit runs, for failNextCommits.
class CommitScope {
 public:
  CommitScope();
  ~CommitScope();
  CommitScope(const CommitScope&) = delete;
  CommitScope& operator=(const CommitScope&) = delete;
};

}  // namespace gluray::accel

// The Embree device: errors, memory accounting, capabilities. Owned by World; any thread may query it.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace gluray::accel {

/// Owns an RTCDevice that prints nothing, reads no configuration file, and counts the memory it holds.
class Device {
 public:
  /// Throws Error if Embree cannot start.
  Device();
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  RTCDeviceTy* handle() const { return device_; }
  /// Packet width that the processor supports natively: 16, 8 or 4 rays.
  int packetWidth() const { return packetWidth_; }
  /// Embree's version, "3.13.5".
  std::string version() const;
  /// Bytes that Embree, and our own leaves (HeldBytes), hold for acceleration structures at present.
  static size_t bytes();
  /// bytes() without the bytes counted by BehindScopes. Only the difference of two calls is meaningful: the
  /// growth outside of such scopes. May be negative, because memory of a scope may be freed outside of the
  /// scope.
  static ptrdiff_t bytesOfFrames();
  /// Throws Error("WHAT: reason") if a call of this thread failed since the last check. A lack of memory
  /// costs frames.
  void check(std::string_view what) const;

 private:
  RTCDeviceTy* device_ = nullptr;
  int packetWidth_ = 4;
};

/// Counts memory of our own as the device's during its lifetime.
class HeldBytes {
 public:
  HeldBytes() = default;
  explicit HeldBytes(size_t bytes);
  ~HeldBytes();
  HeldBytes(HeldBytes&& from) noexcept : bytes_(std::exchange(from.bytes_, 0)) {}
  HeldBytes& operator=(HeldBytes&& from) noexcept {
    std::swap(bytes_, from.bytes_);
    return *this;
  }
  size_t bytes() const { return bytes_; }

 private:
  size_t bytes_ = 0;
};

/// For tests: the next `after` commits succeed, then `count` commits fail as if out of memory.
void failNextCommits(int count, int after = 0);
/// Requested failures that have not happened yet.
int commitsStillToFail();

/// During its lifetime, counts the Embree memory that its thread allocates separately, for background builds.
class BehindScope {
 public:
  BehindScope();
  ~BehindScope();
  BehindScope(const BehindScope&) = delete;
  BehindScope& operator=(const BehindScope&) = delete;
  /// Bytes that this thread allocated in this scope and has not freed.
  size_t bytes() const;
};

/// rtcCommitScene, also inside parallel loops. Device::check of the calling thread reports its failure.
void commitScene(RTCSceneTy* scene);

}  // namespace gluray::accel

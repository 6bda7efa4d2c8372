// What the tracing threads of a rank do with their time while they trace images with light across ranks. Any
// thread.
#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace gluray::cluster {

class PeerTimes {
 public:
  enum Kind : uint8_t {
    eye,     // rays from the viewer
    light,   // shading, with all its rays
    scenes,  // waiting for the scenes of peers; one thread waits for all
    depths,  // waiting for depths of peers
    answers  // waiting for answers about light
  };
  static constexpr size_t kKinds = 5;

  void add(Kind kind, double seconds) noexcept {
    if (seconds > 0)
      nanoseconds_[kind].fetch_add(static_cast<uint64_t>(1e9 * seconds), std::memory_order_relaxed);
  }
  /// The sum over all threads.
  double seconds(Kind kind) const noexcept {
    return 1e-9 * static_cast<double>(nanoseconds_[kind].load(std::memory_order_relaxed));
  }

 private:
  std::array<std::atomic<uint64_t>, kKinds> nanoseconds_{};
};

}  // namespace gluray::cluster

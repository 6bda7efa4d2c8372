// What earlier trials found: seconds of frames in both ways, by load (adr/0125). Shared by the contexts of a
// process that draw with one renderer and one number of threads; intercept/ keeps it between runs. Calls no
// OpenGL and reads no clock. Any thread.
#pragma once
#include "gl/trials/frame_load.h"

#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

namespace gluray::gl {

struct Precedent {
  FrameLoad load;
  double traced = 0, direct = 0;  // seconds of a frame of the ray tracer and of the real OpenGL; positive

  /// Whether both times and the load are finite, and the times positive.
  bool isSane() const;
  bool operator==(const Precedent&) const = default;
};

class Precedents {
 public:
  static constexpr size_t kMost = 64;
  /// Maximum ratio of the loads of a frame and its precedent.
  static constexpr double kSame = 1.5;

  /// The precedent of the most similar load, if there is one.
  std::optional<Precedent> find(const FrameLoad& load) const;
  /// Adds the result of a trial. Replaces that of a similar load, or the oldest one if there are kMost.
  /// Ignores one that is not sane.
  void add(const Precedent& precedent);
  /// All, the oldest first.
  std::vector<Precedent> all() const;

 private:
  mutable std::mutex mutex_;
  std::vector<Precedent> list_;  // the oldest first
};

}  // namespace gluray::gl

// Schedules depth reads ("looks") while many small draws are made. Reads cost time, but a draw can be culled
// only by draws before the last read. Calls no OpenGL. A part of SmallDraws, GL thread.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

namespace gluray::gl {

class LookSchedule {
 public:
  /// Begins a frame. `adapts`: intervals between looks adapt to their benefit; otherwise a look follows each
  /// eighth of the vertices of the depth epoch. `vertices`: number in the previous frame; each first adaptive
  /// look comes after an eighth of them.
  void beginFrame(bool adapts = true, double vertices = 0) {
    adapts_ = adapts, first_ = std::max(kFirst, vertices / 8);
    // The benefit may change slowly, even at looks that have become too rare to show it.
    if (++frames_ % kForgotten == 0) work_ = {};
    next_ = 0;
    beginEpoch();
  }
  /// Begins a depth epoch: earlier looks are no longer valid.
  void beginEpoch() { since_ = 0, inEpoch_ = 0; }
  /// Reports vertices that were drawn.
  void drew(double vertices) { since_ += vertices, inEpoch_ += vertices; }
  bool isDue() const { return since_ >= due(); }
  /// Vertices after the last look at which the next one is due.
  double due() const {
    if (!adapts_) return std::max(kFirst, inEpoch_ / 8);
    size_t at = std::min(next_, kLooks - 1);
    while (work_[at] == 0 && at > 0) --at;
    return work_[at] > 0 ? work_[at] : first_;
  }
  /// Reports a look that took `lookSeconds`. `wastedSeconds`: time spent since the last look on draws that
  /// are now known to be hidden.
  void looked(double wastedSeconds, double lookSeconds) {
    if (!adapts_) return void(since_ = 0);
    double& work = work_[std::min(next_, kLooks - 1)];
    work = due();
    if (wastedSeconds > kFactor * lookSeconds) work = std::max(work / 2, kMin);
    if (wastedSeconds < lookSeconds / kFactor) work = std::min(2 * work, kMax);
    ++next_, since_ = 0;
  }

 private:
  static constexpr size_t kLooks = 32;                            // looks of a frame that have own intervals
  static constexpr double kFirst = 4096, kMin = 512, kMax = 1e9;  // vertices
  static constexpr double kFactor = 2;
  static constexpr unsigned kForgotten = 128;  // frames

  std::array<double, kLooks> work_{};  // interval before each look; 0: that of the previous look
  size_t next_ = 0;
  double first_ = kFirst;           // interval while nothing is known
  double since_ = 0, inEpoch_ = 0;  // vertices since the last look, and in this depth epoch
  bool adapts_ = true;
  unsigned frames_ = 0;
};

}  // namespace gluray::gl

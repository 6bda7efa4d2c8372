// Schedules depth reads while many small draws are made: reads cost time, but a draw can be culled only by
// draws before the last read. Calls no OpenGL. A part of SmallDraws, GL thread.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

namespace gluray::gl {

class LookSchedule {
 public:
  /// A frame begins: its first look is next. `adapts`: looks come more or less often as it pays; else after
  /// each eighth of the work of the depth epoch. `vertices`: of the frame before; the first looks that adapt
  /// come after each eighth of them.
  void beginFrame(bool adapts = true, double vertices = 0) {
    adapts_ = adapts, first_ = std::max(kFirst, vertices / 8);
    // What pays may change slowly, also where looks have become so rare that nothing is found out any more.
    if (++frames_ % kForgotten == 0) work_ = {};
    next_ = 0;
    beginEpoch();
  }
  /// Depths are other ones: what was seen is of no use any more.
  void beginEpoch() { since_ = 0, inEpoch_ = 0; }
  /// So many vertices were drawn.
  void drew(double vertices) { since_ += vertices, inEpoch_ += vertices; }
  bool isDue() const { return since_ >= due(); }
  /// Vertices after which the next look is made.
  double due() const {
    if (!adapts_) return std::max(kFirst, inEpoch_ / 8);
    size_t at = std::min(next_, kLooks - 1);
    while (work_[at] == 0 && at > 0) --at;
    return work_[at] > 0 ? work_[at] : first_;
  }
  /// A look was made, which took `lookSeconds`. `wastedSeconds`: time in which draws were made since the last
  /// one that are hidden now.
  void looked(double wastedSeconds, double lookSeconds) {
    if (!adapts_) return void(since_ = 0);
    double& work = work_[std::min(next_, kLooks - 1)];
    work = due();
    if (wastedSeconds > kFactor * lookSeconds) work = std::max(work / 2, kMin);
    if (wastedSeconds < lookSeconds / kFactor) work = std::min(2 * work, kMax);
    ++next_, since_ = 0;
  }

 private:
  static constexpr size_t kLooks = 32;                            // of a frame, that are told apart
  static constexpr double kFirst = 4096, kMin = 512, kMax = 1e9;  // vertices
  static constexpr double kFactor = 2;
  static constexpr unsigned kForgotten = 128;  // frames

  std::array<double, kLooks> work_{};  // vertices before each look; 0: as before the one before
  size_t next_ = 0;
  double first_ = kFirst;           // where nothing is known yet
  double since_ = 0, inEpoch_ = 0;  // vertices, since the last look and in this depth epoch
  bool adapts_ = true;
  unsigned frames_ = 0;
};

}  // namespace gluray::gl

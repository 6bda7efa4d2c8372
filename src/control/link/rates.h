// Rates over the last second, from counts that are sampled now and then. One thread.
#pragma once
#include "control/link/program/controlled_program.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace gluray::control {

class Rates {
 public:
  static constexpr double kSpan = 1;  // seconds

  /// Counts as of `now`, in seconds; `frame`: the number of the frame that began last.
  void sample(uint64_t frame, const Figures& figures, double now);
  void clear() { samples_.clear(); }

  /// Frames a second; 0 if nothing was drawn.
  double framesPerSecond() const;
  /// Traced triangles of a frame; of those before, while no frame begins.
  uint64_t triangles() const { return triangles_; }
  /// Share of the draws that were traced; none without draws.
  std::optional<double> traced() const;

 private:
  struct Sample {
    uint64_t frame;
    Figures figures;
    double time;
  };
  std::deque<Sample> samples_;  // the newest last; the first may be older than kSpan
  uint64_t triangles_ = 0;
};

}  // namespace gluray::control

// Rates over the last second, from counts that are sampled from time to time. One thread.
#pragma once
#include "control/link/program/controlled_program.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace gluray::control {

class Rates {
 public:
  static constexpr double kSpan = 1;  // seconds

  /// Adds the counts at time `now`, in seconds. `frame`: number of the frame that began last.
  void sample(uint64_t frame, const Figures& figures, double now);
  void clear() { samples_.clear(); }

  /// Frames per second; 0 if nothing was drawn.
  double framesPerSecond() const;
  /// Traced triangles of the last frame with any; unchanged while no frame begins.
  uint64_t triangles() const { return triangles_; }
  /// Share of the draws that were traced; nullopt without draws.
  std::optional<double> traced() const;

 private:
  struct Sample {
    uint64_t frame;
    Figures figures;
    double time;
  };
  std::deque<Sample> samples_;  // newest last; the first may be older than kSpan
  uint64_t triangles_ = 0;
};

}  // namespace gluray::control

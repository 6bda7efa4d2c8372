// How far the image is that the program waits for: for the terminal, reports and controls. One image of the
// process at a time; of images that several threads wait for, the last one tells.
#pragma once
#include "frame/refinement/refinement.h"
#include "settings/settings.h"

#include <optional>
#include <string>

namespace gluray::frame {

struct RefinementProgress {
  double share = 0;        // of the time of all passes, from 0 to 1, as far as the noise so far foretells it
  double noise = 0;        // estimated; infinite: not known yet
  double secondsLeft = 0;  // the rest of that time; infinite: not known before the first pass is complete
};

/// Noise falls with the square root of the number of passes. Passes of earlier waits for the image count, and
/// so does their time.
RefinementProgress progressOf(const Refinement& refinement, const Settings& settings);

/// "gluray: refining the image: 43 %, noise 0.021 of 0.010, 12 s left".
std::string progressLine(const RefinementProgress& progress, const Settings& settings);

/// The progress of the image that a thread of this process waits for; nothing: none takes long. Any thread.
std::optional<RefinementProgress> awaitedProgress() noexcept;

/// Tells the progress of one image while it lives, as soon as it takes long.
class ProgressTeller {
 public:
  explicit ProgressTeller(const Settings& settings);
  ~ProgressTeller();
  ProgressTeller(const ProgressTeller&) = delete;
  ProgressTeller& operator=(const ProgressTeller&) = delete;
  /// Call after each pass.
  void passed(const Refinement& refinement) noexcept;

  static constexpr double kLong = 2;     // seconds from which progress is told
  static constexpr double kEvery = 0.2;  // seconds between two lines

 private:
  const Settings& settings_;
  double next_;
  bool tells_ = false;
};

}  // namespace gluray::frame

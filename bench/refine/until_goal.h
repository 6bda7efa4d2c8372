// How long an image at rest takes until its error is as small as asked, in frames of the local look.
#pragma once
#include "base/image.h"
#include "scene/snapshot.h"

#include <functional>
#include <string>

namespace gluray::bench {

struct Goal {
  double psnr = 40;  // dB over the pixels that hit something, against the reference
  int rounds = 3;    // the medians of so many are taken
  int passes = 256;  // and no more
  Denoise denoise = Denoise::filter;
  std::string keep;  // the file that keeps the reference; empty: none
};

/// The image that another one is compared with: `make`, or what the file `keep` has of that size. Writes the
/// file where there is none. Throws std::runtime_error where it cannot be written.
Image keptImage(const std::string& keep, const scene::Snapshot&, const std::function<Image()>& make);

/// Prints the error after each pass until the goal, how many these are, and what passes, auxiliary features
/// and showing once took, as multiples of frames of the local look that were traced in turn with them; of CPU
/// time of all threads, and of time. Throws std::runtime_error where tracing fails.
void printUntilGoal(const scene::Snapshot&, const Image& reference, const Goal&);

}  // namespace gluray::bench

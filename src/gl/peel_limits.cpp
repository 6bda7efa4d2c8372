#include "gl/peel_limits.h"

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

constexpr uint64_t kSilhouettes = 32;  // pixels that rays and rasterisers may count otherwise
constexpr uint64_t kSeen = 1000;       // of how many pixels one may be left out
constexpr uint32_t kMostDeclines = 8;  // in a row, as long as each teaches something

}  // namespace

uint64_t writtenBehind(const LayerCounts& layers, uint32_t peel) {
  uint64_t pixels = 0;
  for (size_t n = 2 * size_t{peel} - 1; n < LayerCounts::kMost; ++n) {
    if (n >= 2 * size_t{peel}) pixels += layers.open[n];
    if (peel >= 2) pixels += layers.before[n];
  }
  return pixels;
}

bool showsAll(const PeelLimits& limits, const LayerCounts& layers, uint64_t pixels) {
  uint32_t peels = 1;
  while (peels < limits.peels && writtenBehind(layers, peels) >= limits.written) ++peels;
  uint64_t left = 0;
  for (size_t n = 2; n < LayerCounts::kMost; ++n) {
    if ((n + 1) / 2 > peels) left += layers.open[n];
    if (n / 2 + 1 > peels) left += layers.before[n];
  }
  return left <= pixels / kSeen;
}

void PeelWatch::drawn(GLuint depths) {
  if (std::exchange(depths_, depths) == depths) return;
  PeelLimits now = limits_;
  now.peels = std::max(now.peels, ++peels_);
  if (layers_ && peels_ > 1)
    now.written = std::min(now.written, std::max(writtenBehind(*layers_, peels_ - 1), kSilhouettes));
  learned_ = learned_ || !(now == limits_);
  limits_ = now;
}

bool PeelWatch::declined(const LayerCounts& layers) {
  layers_ = layers;
  return !std::exchange(learned_, false) || ++declines_ > kMostDeclines;
}

}  // namespace gluray::gl

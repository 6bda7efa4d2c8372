#include "gl/layers/peel_limits.h"

namespace gluray::gl {
namespace {

constexpr uint64_t kSilhouettes = 32;  // pixels in which rays and rasterisers may disagree
constexpr uint64_t kSeen = 1000;       // at most one in so many pixels may lack layers

}  // namespace

uint64_t writtenBehind(const LayerCounts& layers, uint32_t peel) {
  uint64_t pixels = 0;
  for (size_t n = 2 * size_t{peel} - 1; n < LayerCounts::kMax; ++n) {
    if (n >= 2 * size_t{peel}) pixels += layers.open[n];
    if (peel >= 2) pixels += layers.before[n];
  }
  return pixels;
}

std::optional<uint64_t> surelyWritten(const LayerCounts& layers, uint32_t peel) {
  const uint64_t pixels = writtenBehind(layers, peel);
  if (pixels < kSilhouettes) return std::nullopt;
  return pixels;
}

bool showsAll(uint32_t peels, const LayerCounts& layers, uint64_t pixels) {
  uint64_t left = 0;
  for (size_t n = 2; n < LayerCounts::kMax; ++n) {
    if ((n + 1) / 2 > peels) left += layers.open[n];
    if (n / 2 + 1 > peels) left += layers.before[n];
  }
  return left <= pixels / kSeen;
}

}  // namespace gluray::gl

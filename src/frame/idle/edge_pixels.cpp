#include "frame/idle/edge_pixels.h"

#include "scene/premultiplied.h"

#include <algorithm>

namespace gluray::frame {
namespace {

constexpr int kReach = 2;    // pixels: as far as the widest filter of samples
constexpr int kSimilar = 4;  // difference of channels, 0 .. 255: two pixels apart in a steep gradient

int channelOf(uint32_t color, int channel) { return static_cast<int>(color >> (8 * channel) & 255u); }

/// The mean of colours that are nearly equal.
class EvenColor {
 public:
  /// False: the colour differs from others.
  bool add(uint32_t color) {
    for (int c = 0; c < 3; ++c) {
      const int value = channelOf(color, c);
      low_[c] = std::min(low_[c], value), high_[c] = std::max(high_[c], value);
      if (high_[c] - low_[c] > kSimilar) return false;
      sums_[c] += value;
    }
    return ++count_, true;
  }
  bool empty() const { return count_ == 0; }
  uint32_t mean() const {
    uint32_t mean = 0xff000000u;
    for (int c = 0; c < 3; ++c) mean |= static_cast<uint32_t>((sums_[c] + count_ / 2) / count_) << (8 * c);
    return mean;
  }

 private:
  int low_[3] = {255, 255, 255}, high_[3] = {}, sums_[3] = {}, count_ = 0;
};

}  // namespace

std::optional<uint32_t> colorBehind(const EdgeSurroundings& around, glm::ivec2 at) {
  EvenColor behind;
  bool anyHit = false;
  const bool even = around.compared.around(at, kReach, [&](glm::ivec2 place, size_t pixel) {
    if (around.hits[pixel]) return anyHit = true, bool{around.compared.equal[pixel]};
    const uint32_t* const shown = around.compared.shownAt(place);
    return shown && !around.isCovered(place) && behind.add(*shown);
  });
  if (!even || !anyHit || behind.empty()) return std::nullopt;
  const auto own = static_cast<size_t>(at.y * around.compared.size.x + at.x);
  return around.hits[own] ? behind.mean() : *around.compared.shownAt(at);
}

std::optional<uint32_t> shownColor(uint32_t color, std::optional<uint32_t> behind) {
  const uint32_t alpha = color >> 24;
  if (alpha == 255) return color;
  if (behind) return scene::blended(color, *behind);
  return alpha == 0 ? std::nullopt : std::optional(scene::opaque(color));
}

}  // namespace gluray::frame

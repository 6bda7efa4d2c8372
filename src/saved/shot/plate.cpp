#include "saved/shot/plate.h"

#include "scene/premultiplied.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace gluray::saved {
namespace {

constexpr uint32_t kOpaque = 0xff000000u;
// Differences of channels, 0 .. 255.
constexpr int kAlike = 24;    // noise changes less
constexpr int kRounding = 1;  // of means of a framebuffer's samples

int channelOf(uint32_t color, int channel) { return static_cast<int>(color >> (8 * channel) & 255u); }

bool areAlike(uint32_t a, uint32_t b) {
  for (int c = 0; c < 3; ++c)
    if (std::abs(channelOf(a, c) - channelOf(b, c)) > kRounding) return false;
  return true;
}

/// The mean of four neighbouring pixels by distance; the nearest ones beside the image.
class Between {
 public:
  Between(const std::vector<uint32_t>& pixels, int width, int height, const glm::dvec2& place) {
    const glm::dvec2 at = place - 0.5, low = glm::floor(at);
    share_ = at - low;
    const auto pixel = [&](int dx, int dy) {
      const int x = std::clamp(static_cast<int>(low.x) + dx, 0, width - 1),
                y = std::clamp(static_cast<int>(low.y) + dy, 0, height - 1);
      return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    };
    near_ = {pixel(0, 0), pixel(1, 0), pixel(0, 1), pixel(1, 1)};
  }
  uint32_t bytes() const {
    if (isEven()) return near_[0];
    uint32_t mean = 0;
    for (int c = 0; c < 4; ++c) mean |= static_cast<uint32_t>(std::lround(channel(c))) << (8 * c);
    return mean;
  }
  glm::vec4 wide() const {
    if (isEven()) return scene::wideOf(near_[0]);
    return glm::dvec4(channel(0), channel(1), channel(2), channel(3)) / 255.0;
  }

 private:
  bool isEven() const { return near_[0] == near_[1] && near_[0] == near_[2] && near_[0] == near_[3]; }
  double channel(int c) const {
    const double below = channelOf(near_[0], c) * (1 - share_.x) + channelOf(near_[1], c) * share_.x,
                 above = channelOf(near_[2], c) * (1 - share_.x) + channelOf(near_[3], c) * share_.x;
    return below * (1 - share_.y) + above * share_.y;
  }

  std::array<uint32_t, 4> near_{};
  glm::dvec2 share_{0};
};

}  // namespace

Plate::Plate(const SavedPicture& shown, const std::vector<uint32_t>& traced, bool exact)
    : width_(shown.width), height_(shown.height), shown_(shown.pixels), overlay_(traced.size()) {
  isBackground_.resize(traced.size());
  for (size_t i = 0; i < traced.size(); ++i) {
    shown_[i] |= kOpaque;
    isBackground_[i] = traced[i] >> 24 == 0;
  }
  background_ = shown_;
  fillBehind(awayFromSurfaces());
  size_t i = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x, ++i)
      if (isOverlay(traced, {x, y}, exact)) overlay_[i] = shown_[i], ++overlays_;
}

/// Whether the window shows something else than the surface at a pixel.
bool Plate::isOverlay(const std::vector<uint32_t>& traced, glm::ivec2 pixel, bool exact) const {
  const size_t at = indexOf(pixel);
  const uint32_t shown = shown_[at];
  if (isBackground_[at] || areAlike(shown, scene::blended(traced[at], background_[at]))) return false;
  if (exact) return true;
  if (traced[at] >> 24 != 255) return false;  // an edge
  const glm::ivec2 low = glm::max(pixel - 1, 0), high = glm::min(pixel + 1, glm::ivec2(width_, height_) - 1);
  for (int c = 0; c < 3; ++c) {
    int least = 255, most = 0;
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const size_t i = indexOf({x, y});
        const int value = channelOf(isBackground_[i] ? shown_[i] : traced[i], c);
        least = std::min(least, value), most = std::max(most, value);
      }
    const int value = channelOf(shown, c);
    if (value < least - kAlike || value > most + kAlike) return true;
  }
  return false;
}

/// Pixels whose neighbours show no surface either.
std::vector<uint8_t> Plate::awayFromSurfaces() const {
  std::vector<uint8_t> away(isBackground_.size());
  const auto isFree = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return true;
    return isBackground_[indexOf({x, y})] != 0;
  };
  const auto rowFree = [&](int x, int y) { return isFree(x - 1, y) && isFree(x, y) && isFree(x + 1, y); };
  size_t i = 0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) away[i++] = rowFree(x, y - 1) && rowFree(x, y) && rowFree(x, y + 1);
  return away;
}

uint32_t Plate::roundedAsShown(glm::ivec2 pixel, uint32_t color) const {
  if (empty()) return color;
  const uint32_t shown = shown_[indexOf(pixel)];
  return areAlike(shown, color) ? shown : color;
}

uint32_t Plate::windowBackgroundAt(glm::ivec2 pixel) const {
  const size_t i = indexOf(pixel);
  return isBackground_[i] ? shown_[i] : background_[i];
}

/// Gives unknown pixels the colour of the nearest known one, ring by ring.
void Plate::fillBehind(std::vector<uint8_t> known) {
  std::vector<uint32_t> ring, next;
  for (size_t i = 0; i < known.size(); ++i)
    if (known[i]) ring.push_back(static_cast<uint32_t>(i));
  while (!ring.empty()) {
    next.clear();
    for (const uint32_t from : ring) {
      const int x = static_cast<int>(from) % width_, y = static_cast<int>(from) / width_;
      const auto take = [&](int u, int v) {
        if (u < 0 || v < 0 || u >= width_ || v >= height_) return;
        const auto to = static_cast<uint32_t>(v * width_ + u);
        if (known[to]) return;
        known[to] = 1, background_[to] = background_[from];
        next.push_back(to);
      };
      take(x - 1, y), take(x + 1, y), take(x, y - 1), take(x, y + 1);
    }
    ring.swap(next);
  }
}

uint32_t Plate::backgroundAt(const glm::dvec2& place) const {
  return empty() ? 0 : Between(background_, width_, height_, place).bytes();
}

uint32_t Plate::overlayAt(const glm::dvec2& place) const {
  return overlays_ == 0 ? 0 : Between(overlay_, width_, height_, place).bytes();
}

glm::vec4 Plate::wideBackgroundAt(const glm::dvec2& place) const {
  return empty() ? glm::vec4(0) : Between(background_, width_, height_, place).wide();
}

glm::vec4 Plate::wideOverlayAt(const glm::dvec2& place) const {
  return overlays_ == 0 ? glm::vec4(0) : Between(overlay_, width_, height_, place).wide();
}

void Plate::clearBackground() {
  std::vector<int> values;
  std::vector<uint8_t> rows(static_cast<size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    const auto first = static_cast<size_t>(y) * static_cast<size_t>(width_);
    uint32_t middle = kOpaque;
    for (int c = 0; c < 3; ++c) {
      values.clear();
      for (size_t i = first; i < first + static_cast<size_t>(width_); ++i)
        if (isBackground_[i]) values.push_back(channelOf(background_[i], c));
      if (values.empty()) break;
      const auto half = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
      std::nth_element(values.begin(), half, values.end());
      middle |= static_cast<uint32_t>(*half) << (8 * c);
    }
    rows[static_cast<size_t>(y)] = !values.empty();
    std::fill_n(background_.begin() + static_cast<ptrdiff_t>(first), width_, middle);
  }
  std::vector<uint8_t> known(background_.size());
  for (size_t i = 0; i < known.size(); ++i) known[i] = rows[i / static_cast<size_t>(width_)];
  fillBehind(std::move(known));
  overlays_ = 0;
}

}  // namespace gluray::saved

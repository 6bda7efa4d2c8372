// Visibility and surfaces of a frame's pixels, packed because reprojection is limited by memory
// bandwidth. Written by the tracing threads of a frame, read by those of the next frame.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::render {

/// Two words a pixel hold its surface and two channels; each further channel is a plane of its own.
///   words[2 * pixel]     depth (20 bits), first channel (12)
///   words[2 * pixel + 1] normal (7 + 7, octahedral), samples (6), second channel (12)
/// Depth is PixelSpace's, as the leading bits of a float; pixels without samples are empty. Visibility is 0
/// .. 1.
struct VisibilityBuffer {
  static constexpr uint32_t kMaxSamples = 63;
  static constexpr uint32_t kVisibilityBits = 0xFFFu;   // of both words
  static constexpr uint32_t kNormalBits = 0xFFFC0000u;  // of the second
  static constexpr float kLargest = 4095;               // of a packed channel
  static constexpr float kLargestMore = 65535;          // of one in a plane of its own

  int width = 0, height = 0, channels = 0;
  std::vector<uint32_t> words;
  std::vector<std::vector<uint16_t>> more;

  size_t pixels() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
  /// Contents are undefined afterwards. Throws std::bad_alloc.
  void resize(int newWidth, int newHeight, int newChannels) {
    width = newWidth, height = newHeight, channels = newChannels;
    words.resize(2 * pixels());
    more.resize(static_cast<size_t>(channels > 2 ? channels - 2 : 0));
    for (auto& plane : more) plane.resize(pixels());
  }
  /// Sets factor number `f` among those with planes of their own.
  void setMore(int f, size_t pixel, float value) {
    more[static_cast<size_t>(f - 2)][pixel] =
        static_cast<uint16_t>(std::clamp(value, 0.0f, 1.0f) * kLargestMore + 0.5f);
  }
  /// Empties the pixels of a rectangle.
  void clear(int x0, int y0, int x1, int y1) {
    for (int y = y0; y < y1; ++y) {
      const auto row = words.begin() + 2 * static_cast<ptrdiff_t>(y) * width;
      std::fill(row + 2 * static_cast<ptrdiff_t>(x0), row + 2 * static_cast<ptrdiff_t>(x1), 0u);
    }
  }
  size_t bytes() const {
    size_t sum = words.capacity() * sizeof(uint32_t);
    for (const auto& plane : more) sum += plane.capacity() * sizeof(uint16_t);
    return sum;
  }
};

}  // namespace gluray::render

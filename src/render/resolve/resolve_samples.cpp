#include "render/resolve/resolve_samples.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace gluray::render {
namespace {

constexpr int kMaxSamples = 64;  // the tracer's limit

/// Power mean of bytes. The result lies between the smallest and the largest input, so few candidates are
/// tried.
class PowerMean {
 public:
  explicit PowerMean(float gamma) {
    for (int i = 0; i < 256; ++i) {
      powers_[static_cast<size_t>(i)] = std::pow(static_cast<float>(i) / 255.0f, gamma);
      from_[static_cast<size_t>(i)] = std::pow((static_cast<float>(i) - 0.5f) / 255.0f, gamma);
    }
  }
  uint32_t of(const uint32_t* colors, int count, int shift) const {
    float sum = 0;
    uint32_t least = 255, most = 0;
    for (int i = 0; i < count; ++i) {
      const uint32_t byte = colors[i] >> shift & 255u;
      sum += powers_[byte];
      least = std::min(least, byte), most = std::max(most, byte);
    }
    const float mean = sum / static_cast<float>(count);
    return static_cast<uint32_t>(std::upper_bound(from_.begin() + least + 1, from_.begin() + most + 1, mean) -
                                 from_.begin() - 1);
  }

 private:
  std::array<float, 256> powers_{};  // of each byte
  std::array<float, 256> from_{};    // least mean power for which the result is that byte
};

/// Mean with software OpenGLs' order of operations and rounding, which decide halves: these are frequent.
uint32_t mean(const uint32_t* colors, int count, int shift) {
  float sum = 0;
  for (int i = 0; i < count; ++i) sum += static_cast<float>(colors[i] >> shift & 255u) * (1.0f / 255.0f);
  const float average = sum * (1.0f / static_cast<float>(count));
  return std::bit_cast<uint32_t>(average * (255.0f / 256.0f) + 32768.0f) & 255u;
}

/// An average over rays, premultiplied by its coverage, over the background. Red, green and blue are mixed
/// with the exponent `gamma`.
uint32_t over(uint32_t average, uint32_t background, float gamma) {
  const float share = static_cast<float>(average >> 24) / 255;
  uint32_t result = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto above = static_cast<float>(average >> shift & 255u),
               below = static_cast<float>(background >> shift & 255u);
    float mixed = above + (1 - share) * below;
    if (gamma != 1 && shift < 24 && share > 0)
      mixed =
          std::pow(share * std::pow(above / share, gamma) + (1 - share) * std::pow(below, gamma), 1 / gamma);
    result |= static_cast<uint32_t>(std::lround(std::min(mixed, 255.0f))) << shift;
  }
  return result;
}

/// Resolves rows of an image.
class Rows {
 public:
  Rows(const scene::Resolve& how, const Image& samples)
      : how_(how),
        powerMean_(how.gamma),
        samples_(samples),
        plane_(static_cast<size_t>(samples.width) * static_cast<size_t>(samples.height)) {}

  /// The same for averages, which cover all samples of a pixel.
  void resolveAverages(size_t from, size_t count, uint32_t* colors, float* depths) const {
    for (size_t i = 0; i < count; ++i) {
      const bool seen = samples_.depth[from + i] <= how_.farthest;
      colors[i] = seen ? over(samples_.color[from + i], how_.background, how_.gamma) : how_.background;
      const float depth = samples_.centerDepth[from + i];
      depths[i] = depth <= how_.farthest ? depth : 1.0f;
    }
  }

  /// Resolves `count` pixels from pixel `from` of the image. N: samples; 0: the image's number.
  template <int N>
  void resolve(size_t from, size_t count, uint32_t* colors, float* depths) const {
    const int n = N > 0 ? N : std::min(samples_.samples, kMaxSamples);
    std::array<uint32_t, N ? N : kMaxSamples> own{};
    for (size_t i = 0; i < count; ++i) {
      uint32_t differ = 0;
      for (int s = 0; s < n; ++s) {
        const size_t at = from + i + plane_ * static_cast<size_t>(s);
        own[static_cast<size_t>(s)] =
            samples_.depth[at] <= how_.farthest ? samples_.color[at] : how_.background;
        differ |= own[static_cast<size_t>(s)] ^ own[0];
      }
      colors[i] = differ ? average(own.data(), n, differ) : own[0];
      const float depth = samples_.depth[from + i];
      depths[i] = depth <= how_.farthest ? depth : 1.0f;
    }
  }

 private:
  uint32_t average(const uint32_t* colors, int count, uint32_t differ) const {
    uint32_t result = colors[0];
    for (int shift = 0; shift < 32; shift += 8) {
      if (!(differ >> shift & 255u)) continue;
      const bool plain = how_.gamma == 1 || shift == 24;
      const uint32_t byte = plain ? mean(colors, count, shift) : powerMean_.of(colors, count, shift);
      result = (result & ~(255u << shift)) | byte << shift;
    }
    return result;
  }

  const scene::Resolve& how_;
  PowerMean powerMean_;
  const Image& samples_;
  size_t plane_;  // pixels per sample plane
};

}  // namespace

void resolve(const scene::Resolve& how, const Image& samples, Image& out) {
  out.resize(how.size.x, how.size.y, 1);
  out.x = out.y = 0;
  const auto width = static_cast<size_t>(samples.width);
  const Rows all(how, samples);
  const int first = std::clamp(samples.x, 0, how.size.x),
            last = std::clamp(samples.x + samples.width, first, how.size.x);
  tbb::parallel_for(tbb::blocked_range<int>(0, how.size.y, 16), [&](const tbb::blocked_range<int>& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) {
      const auto start = static_cast<ptrdiff_t>(y) * how.size.x;
      std::fill_n(out.color.begin() + start, how.size.x, how.background);
      std::fill_n(out.depth.begin() + start, how.size.x, 1.0f);
      const int within = y - samples.y;
      if (within < 0 || within >= samples.height || first == last) continue;
      const auto from = static_cast<size_t>(within) * width + static_cast<size_t>(first - samples.x);
      const auto count = static_cast<size_t>(last - first);
      uint32_t* const colors = &out.color[static_cast<size_t>(start + first)];
      float* const depths = &out.depth[static_cast<size_t>(start + first)];
      if (samples.isAverages())
        all.resolveAverages(from, count, colors, depths);
      else if (samples.samples == 4)
        all.resolve<4>(from, count, colors, depths);
      else
        all.resolve<0>(from, count, colors, depths);
    }
  });
}

}  // namespace gluray::render

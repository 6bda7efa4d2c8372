#include "render/fxaa.h"

#include <glm/glm.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/fxaa.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Luminosity of a row's pixels, in the order of operations that software OpenGLs have: where contrasts are
/// equal the rounding decides.
HWY_ATTR void luminosityOfRow(const uint32_t* pixels, size_t count, float* out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const hn::RebindToSigned<decltype(d)> di;
  const auto byteMask = hn::Set(du, 255u);
  const auto unit = hn::Set(d, 1.0f / 255), r = hn::Set(d, 0.299f), g = hn::Set(d, 0.587f),
             b = hn::Set(d, 0.114f);
  const size_t step = hn::Lanes(d);
  size_t i = 0;
  for (; i + step <= count; i += step) {
    const auto p = hn::LoadU(du, pixels + i);
    const auto channel = [&](auto v) HWY_ATTR {
      return hn::Mul(hn::ConvertTo(d, hn::BitCast(di, hn::And(v, byteMask))), unit);
    };
    const auto sum = hn::Add(
        hn::Add(hn::Mul(channel(hn::ShiftRight<16>(p)), b), hn::Mul(channel(hn::ShiftRight<8>(p)), g)),
        hn::Mul(channel(p), r));
    hn::StoreU(sum, d, out + i);
  }
  for (; i < count; ++i) {
    const uint32_t p = pixels[i];
    const auto channel = [](uint32_t v) { return static_cast<float>(v & 255) * (1.0f / 255); };
    out[i] = (channel(p >> 16) * 0.114f + channel(p >> 8) * 0.587f) + channel(p) * 0.299f;
  }
}

/// First pixel in [from, count) whose contrast to its four neighbours reaches the thresholds; count if none.
/// Looks at [1, count - 1) only; the rows are those below, of, and above the pixels.
HWY_ATTR size_t nextContrast(const float* below, const float* row, const float* above, size_t from,
                             size_t count, float relative, float hard) {
  const hn::ScalableTag<float> d;
  const size_t step = hn::Lanes(d);
  size_t i = from;
  for (; i + step + 1 <= count; i += step) {
    const auto c = hn::LoadU(d, row + i), n = hn::LoadU(d, below + i), s = hn::LoadU(d, above + i),
               w = hn::LoadU(d, row + i - 1), e = hn::LoadU(d, row + i + 1);
    const auto least = hn::Min(c, hn::Min(hn::Min(n, s), hn::Min(w, e)));
    const auto most = hn::Max(c, hn::Max(hn::Max(n, s), hn::Max(w, e)));
    const auto threshold = hn::Max(hn::Set(d, hard), hn::Mul(hn::Set(d, relative), most));
    const auto reached = hn::Ge(hn::Sub(most, least), threshold);
    if (const intptr_t at = hn::FindFirstTrue(d, reached); at >= 0) return i + static_cast<size_t>(at);
  }
  for (; i + 1 < count; ++i) {
    const float least = std::min({row[i], below[i], above[i], row[i - 1], row[i + 1]});
    const float most = std::max({row[i], below[i], above[i], row[i - 1], row[i + 1]});
    if (!(most - least < std::max(hard, relative * most))) return i;
  }
  return i;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gluray::render {
namespace {

HWY_EXPORT(luminosityOfRow);
HWY_EXPORT(nextContrast);

/// To the nearest whole number, halves upwards, of a number that is not negative.
uint32_t rounded(float v) {
  const auto whole = static_cast<uint32_t>(v);
  return v - static_cast<float>(whole) >= 0.5f ? whole + 1 : whole;
}

/// One picture and its luminosity. `inside`: every pixel that is asked for is there; otherwise those beyond
/// the border are the nearest within.
template <bool inside>
class Filter {
 public:
  Filter(const scene::Fxaa& settings, const uint32_t* in, const float* luminosity, int width, int height)
      : settings_(settings), in_(in), luminosity_(luminosity), width_(width), height_(height) {}

  /// The pixel's new colour.
  uint32_t at(int x, int y) const {
    const float c = lum(x, y), n = lum(x, y - 1), s = lum(x, y + 1), w = lum(x - 1, y), e = lum(x + 1, y);
    const float least = std::min({c, n, s, w, e}), most = std::max({c, n, s, w, e}), range = most - least;
    if (range < std::max(settings_.hardContrast, settings_.relativeContrast * most)) return pixel(x, y);
    const float ne = lum(x + 1, y - 1), se = lum(x + 1, y + 1), nw = lum(x - 1, y - 1),
                sw = lum(x - 1, y + 1);
    const float ns = n + s, we = w + e, nwne = nw + ne, swse = sw + se, nwsw = nw + sw, nese = ne + se;
    const float blend = subpixelBlend(c, ns + we, range);
    const float rows[3] = {std::abs(-2 * n + nwne), std::abs(-2 * c + we), std::abs(-2 * s + swse)};
    const float columns[3] = {std::abs(-2 * w + nwsw), std::abs(-2 * c + ns), std::abs(-2 * e + nese)};
    const float vertical = ((2 * rows[1] + rows[0]) + rows[2]) / 12;
    const float horizontal = ((2 * columns[1] + columns[0]) + columns[2]) / 12;
    const bool alongX = horizontal >= vertical;
    const float one = alongX ? n : w, other = alongX ? s : e;
    const bool towardsOne = std::abs(c - one) >= std::abs(c - other);
    const glm::vec3 edge = alongEdge(x, y, c, towardsOne ? one : other, alongX, towardsOne ? -1 : 1);
    const glm::vec3 result = blend == 0 ? edge : glm::mix(edge, mean3x3(x, y), blend);
    const glm::vec3 bytes = glm::clamp(result, 0.0f, 1.0f) * 255.0f;
    return rounded(bytes.r) | rounded(bytes.g) << 8 | rounded(bytes.b) << 16 | (pixel(x, y) & 0xFF000000u);
  }

 private:
  size_t index(int x, int y) const {
    if constexpr (inside)
      return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
    return static_cast<size_t>(std::clamp(y, 0, height_ - 1)) * static_cast<size_t>(width_) +
           static_cast<size_t>(std::clamp(x, 0, width_ - 1));
  }
  float lum(int x, int y) const { return luminosity_[index(x, y)]; }
  uint32_t pixel(int x, int y) const { return in_[index(x, y)]; }
  glm::vec3 rgb(int x, int y) const {
    const uint32_t p = pixel(x, y);
    return glm::vec3(p & 255, p >> 8 & 255, p >> 16 & 255) * (1.0f / 255);
  }
  glm::vec3 mean3x3(int x, int y) const {
    glm::vec3 sum(0);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) sum += rgb(x + dx, y + dy);
    return sum * (1.0f / 9);
  }
  float subpixelBlend(float c, float neighbours, float range) const {
    const float contrast = std::abs(0.25f * neighbours - c) / range;
    const float blend = std::max(0.0f, contrast - settings_.subpixelContrast);
    return std::min(settings_.subpixelBlendLimit, blend * (1 / (1 - settings_.subpixelContrast)));
  }

  /// Where an edge ends in one direction: pixels away, and the luminosity there on the pixel's side.
  struct End {
    int distance = 1;
    float luminosity = 0;
  };
  End follow(int x, int y, int dx, int dy, int sideX, int sideY, float c, float across) const {
    End end;
    for (int i = 0; i < settings_.endpointSearchIterations; ++i, ++end.distance) {
      const int px = x + dx * end.distance, py = y + dy * end.distance;
      const float there = lum(px + sideX, py + sideY);
      end.luminosity = lum(px, py);
      if (std::abs(there - across) > std::abs(there - c) ||
          std::abs(end.luminosity - c) > std::abs(end.luminosity - across))
        break;
    }
    return end;
  }

  /// Whether the first of two ends is nearer. The program compares texture coordinates that it came by in
  /// steps; among equal distances the rounding of its floats decides.
  static bool isNearer(int at, int size, int before, int after) {
    if (before != after) return before < after;
    const float step = 1.0f / static_cast<float>(size), place = (static_cast<float>(at) + 0.5f) * step;
    float n = place - step, p = place + step;
    for (int i = 1; i < before; ++i) n -= step;
    for (int i = 1; i < after; ++i) p += step;
    return place - n < p - place;
  }

  /// The colour between the pixel and the one across the edge.
  glm::vec3 alongEdge(int x, int y, float c, float across, bool alongX, int side) const {
    const int dx = alongX ? 1 : 0, dy = alongX ? 0 : 1, sideX = alongX ? 0 : side, sideY = alongX ? side : 0;
    const End n = follow(x, y, -dx, -dy, sideX, sideY, c, across),
              p = follow(x, y, dx, dy, sideX, sideY, c, across);
    const bool nIsNearest =
        alongX ? isNearer(x, width_, n.distance, p.distance) : isNearer(y, height_, n.distance, p.distance);
    const End& nearest = nIsNearest ? n : p;
    const glm::vec3 here = rgb(x, y);
    if (!(std::abs(nearest.luminosity - across) < std::abs(nearest.luminosity - c))) return here;
    const float offset =
        0.5f - static_cast<float>(nearest.distance) / static_cast<float>(n.distance + p.distance);
    return glm::mix(here, rgb(x + sideX, y + sideY), offset);
  }

  const scene::Fxaa& settings_;
  const uint32_t* in_;
  const float* luminosity_;
  int width_, height_;
};

}  // namespace

void fxaa(const scene::Fxaa& settings, const uint32_t* in, int width, int height, uint32_t* out,
          FxaaMemory& memory) {
  const auto w = static_cast<size_t>(width), h = static_cast<size_t>(height);
  memory.luminosity.resize(w * h);
  float* lum = memory.luminosity.data();
  constexpr size_t kRows = 16;
  tbb::parallel_for(tbb::blocked_range<size_t>(0, h, kRows), [&](const auto& rows) {
    for (size_t y = rows.begin(); y != rows.end(); ++y)
      HWY_DYNAMIC_DISPATCH(luminosityOfRow)(in + y * w, w, lum + y * w);
  });
  const Filter<true> filter(settings, in, lum, width, height);
  const Filter<false> atBorder(settings, in, lum, width, height);
  const int margin = std::max(settings.endpointSearchIterations, 1) + 1;
  tbb::parallel_for(tbb::blocked_range<size_t>(0, h, kRows), [&](const auto& rows) {
    for (size_t y = rows.begin(); y != rows.end(); ++y) {
      uint32_t* to = out + y * w;
      std::copy_n(in + y * w, w, to);
      const int row = static_cast<int>(y);
      to[0] = atBorder.at(0, row);
      if (w > 1) to[w - 1] = atBorder.at(width - 1, row);
      const bool rowInside = row >= margin && row < height - margin;
      const float* middle = lum + y * w;
      const float *below = y > 0 ? middle - w : middle, *above = y + 1 < h ? middle + w : middle;
      for (size_t x = 1; x + 1 < w; ++x) {
        x = HWY_DYNAMIC_DISPATCH(nextContrast)(below, middle, above, x, w, settings.relativeContrast,
                                               settings.hardContrast);
        if (x + 1 >= w) break;
        const int column = static_cast<int>(x);
        const bool isInside = rowInside && column >= margin && column < width - margin;
        to[x] = isInside ? filter.at(column, row) : atBorder.at(column, row);
      }
    }
  });
}

}  // namespace gluray::render
#endif

// The pixels of a tile of the wavelet filter: light, and the features that it is compared by. Compiled once
// for each instruction set.
#if defined(GLURAY_RENDER_RESOLVE_WAVELET_PLANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_RESOLVE_WAVELET_PLANES_INL_H_
#undef GLURAY_RENDER_RESOLVE_WAVELET_PLANES_INL_H_
#else
#define GLURAY_RENDER_RESOLVE_WAVELET_PLANES_INL_H_
#endif

#include "render/local/fragment.inl.h"
#include "render/resolve/feature_pixels.h"
#include "render/resolve/wavelet.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

constexpr int kSide = WaveletTile::kSize + 2 * WaveletTile::kReach;
constexpr int kStride = (kSide + 15) / 16 * 16 + 16;  // whole vectors from any pixel on
constexpr int kArea = kStride * kSide;

/// A tile with its surroundings: planes of kStride x kSide values.
struct WaveletPlanes {
  float *red[3], *a, *b, *c, *distance;  // red: kOnCatcher on a catcher
  float *nearness, *z;                   // 1 / distance, or 0; the normal's third component
  float *cover, *spread;                 // cover: at most 1, negative where the pixel mixes surfaces
  float* light[2][4];                    // red, green, blue, variance; read and written in turn
  explicit WaveletPlanes(float* memory) {
    const auto next = [&]() HWY_ATTR {
      float* const plane = memory;
      memory += kArea;
      return plane;
    };
    for (float*& plane : red) plane = next();
    a = next(), b = next(), c = next(), distance = next(), nearness = next(), z = next(), cover = next(),
    spread = next();
    for (auto& set : light)
      for (float*& plane : set) plane = next();
  }
  static constexpr int kCount = 19;
  static constexpr float kOnCatcher = -4;  // reflectance unlike that of any surface
};

HWY_INLINE Float at(const float* plane, int i) { return hn::LoadU(FloatTag(), plane + i); }
HWY_INLINE void put(Float v, float* plane, int i) { hn::StoreU(v, FloatTag(), plane + i); }

/// A pixel's colour is light times `factor`, and what shows behind the surfaces or has no noise.
struct Demodulation {
  float factor[3] = {1, 1, 1}, behind[3] = {}, cover = 1;
  bool onCatcher = false;  // its light is alpha / cover
  float scale() const { return std::max({factor[0], factor[1], factor[2]}); }
};

/// Adds up the colours of the pixels without surfaces at most `reach` pixels away. Returns their number.
inline int addBehind(const NoisyImage& in, int x, int y, int reach, float* sum) {
  int count = 0;
  for (int v = std::max(y - reach, 0); v <= std::min(y + reach, in.height - 1); ++v)
    for (int u = std::max(x - reach, 0); u <= std::min(x + reach, in.width - 1); ++u) {
      const size_t i = static_cast<size_t>(v) * static_cast<size_t>(in.width) + static_cast<size_t>(u);
      if (in.features.distance[i] > 0) continue;
      for (size_t c = 0; c < 3; ++c) sum[c] += in.color[4 * i + c];
      ++count;
    }
  return count;
}

/// Returns whether the pixel's light is known.
inline bool demodulate(const NoisyImage& in, int x, int y, Demodulation& d) {
  const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(in.width) + static_cast<size_t>(x);
  const FeatureView& g = in.features;
  const float* const color = in.color + 4 * pixel;
  if (!(g.distance[pixel] > 0 && std::isfinite(color[0] + color[1] + color[2]))) return false;
  const glm::vec3 reflectance = unpackReflectance(g.reflectance[pixel]);
  d = {};
  if (g.coverage) {
    const float cover = unpackCoverage(g.coverage[pixel]);
    d.onCatcher = cover < 0, d.cover = std::abs(cover);
    if (!(d.cover > 0)) return false;
  }
  for (int c = 0; c < 3; ++c) d.factor[c] = reflectance[c] * d.cover;
  if (g.noiseless) {
    const glm::vec3 light = unpackReflectance(g.noiseless[pixel]);
    for (int c = 0; c < 3; ++c) d.behind[c] = light[c];
    return true;
  }
  if (!in.backdrop || d.onCatcher || d.cover == 1) return true;
  int count = 0;
  for (int reach = 1; reach <= 2 && !count; ++reach) count = addBehind(in, x, y, reach, d.behind);
  if (!count) return false;
  for (float& v : d.behind) v *= (1 - d.cover) / static_cast<float>(count);
  return true;
}

/// Light of a pixel, which is left out where it is no number. Returns whether it counts.
HWY_ATTR inline bool unpackPixel(const NoisyImage& in, int x, int y, WaveletPlanes& p, int i) {
  Demodulation d;
  if (!demodulate(in, x, y, d)) return false;
  const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(in.width) + static_cast<size_t>(x);
  const FeatureView& g = in.features;
  const float* const color = in.color + 4 * pixel;
  const glm::vec3 reflectance = unpackReflectance(g.reflectance[pixel]);
  const glm::vec2 normal = unpackNormal2(g.normal[pixel]);
  p.distance[i] = g.distance[pixel], p.nearness[i] = 1 / p.distance[i], p.a[i] = normal.x, p.b[i] = normal.y;
  p.c[i] = unpackFacing(g.facing[pixel]);
  p.z[i] = std::sqrt(std::max(1 - glm::dot(normal, normal), 0.0f));
  p.cover[i] = std::min(d.cover, 1.0f);
  if (g.coverage && p.c[i] > 0) p.c[i] = -p.c[i], p.cover[i] = -p.cover[i];
  p.spread[i] = g.spread ? unpackCoverage(g.spread[pixel]) : 0;
  for (int c = 0; c < 3; ++c) {
    p.red[c][i] = d.onCatcher ? WaveletPlanes::kOnCatcher : reflectance[c];
    const float own = std::min(color[d.onCatcher ? 3 : c], in.most);
    p.light[0][c][i] = (own - d.behind[c]) / d.factor[c];
  }
  const float error = in.noise ? static_cast<float>(in.noise[pixel]) / kNoiseOne : 0;
  const float scaled = error / d.scale();
  p.light[0][3][i] = scaled * scaled;
  return true;
}

/// False: nothing can be smoothed.
HWY_ATTR inline bool unpackPlanes(const NoisyImage& in, const WaveletTile& tile, WaveletPlanes& p) {
  std::fill_n(p.red[0], WaveletPlanes::kCount * kArea, 0.0f);
  bool any = false;
  for (int row = 0; row < kSide; ++row) {
    const int y = tile.y - WaveletTile::kReach + row, left = tile.x - WaveletTile::kReach;
    if (y < 0 || y >= in.height) continue;
    for (int x = std::max(left, 0); x < std::min(left + kSide, in.width); ++x) {
      any |= unpackPixel(in, x, y, p, row * kStride + x - left);
    }
  }
  return any;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif

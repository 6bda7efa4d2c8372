// Light of pixels that mix surfaces, from neighbours that show one surface alone. Part of the wavelet filter;
// compiled once for each instruction set.
#if defined(GLURAY_RENDER_RESOLVE_UNMIX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_RESOLVE_UNMIX_INL_H_
#undef GLURAY_RENDER_RESOLVE_UNMIX_INL_H_
#else
#define GLURAY_RENDER_RESOLVE_UNMIX_INL_H_
#endif

#include "render/resolve/wavelet_planes.inl.h"

#include <glm/glm.hpp>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

constexpr int kUnmixReach = 3;  // pixels; wavelet rounds compute light that far around a tile

/// Features by which the parts of a pixel are told: two coordinates of the normal, the distance relative to
/// that of the pixel, red, green and blue of the reflectance.
struct PartFeatures {
  static constexpr int kCount = 6;
  float value[kCount] = {};
};

inline PartFeatures featuresAt(const WaveletPlanes& p, int j, float distance) {
  constexpr float kDistance = 0.02f;  // difference that counts as much as normals at right angles
  return {{p.a[j], p.b[j], distance / kDistance, p.red[0][j], p.red[1][j], p.red[2][j]}};
}

/// The part of a mixed pixel that shows one surface, as means over its neighbours.
struct MixedPart {
  glm::vec3 light{0};
  PartFeatures mean, variance;
  float weight = 0;
  void add(const glm::vec3& pixelLight, const PartFeatures& features, float w) {
    light += w * pixelLight, weight += w;
    for (int k = 0; k < PartFeatures::kCount; ++k) {
      const float v = features.value[k];
      mean.value[k] += w * v, variance.value[k] += w * v * v;
    }
  }
  void finish() {
    light /= weight;
    for (int k = 0; k < PartFeatures::kCount; ++k) {
      float &m = mean.value[k], &v = variance.value[k];
      m /= weight, v = std::max(v / weight - m * m, 0.0f);
    }
  }
  float reflectance(int channel) const { return mean.value[3 + channel]; }
};

/// Calls each(j, dx, dy) for the pixels around pixel i that show one surface alone.
template <class Each>
inline void eachPure(const WaveletPlanes& p, int i, Each&& each) {
  for (int dy = -kUnmixReach; dy <= kUnmixReach; ++dy)
    for (int dx = -kUnmixReach; dx <= kUnmixReach; ++dx) {
      const int j = i + dy * kStride + dx;
      if (p.distance[j] > 0 && p.cover[j] > 0 && p.red[0][j] > 0) each(j, dx, dy);
    }
}

/// Light is smooth already, so that the nearest pixels count most.
inline float nearness(int dx, int dy) {
  const auto square = static_cast<float>(dx * dx + dy * dy + 1);
  return 1 / (square * square);
}

/// Whether pixels j and k, which is (dx, dy) pixels from j, show one surface; reflectance does not matter.
inline bool showOneSurface(const WaveletPlanes& p, int j, int k, int dx, int dy) {
  constexpr float kOffPlane = 0.5f, kOffFar = 0.1f, kCosine = 0.9f;  // pixels, and more for each pixel away
  const auto along = static_cast<float>(dx) * p.a[j] + static_cast<float>(dy) * p.b[j];
  const float off = along + p.c[j] * (1 - p.distance[j] / p.distance[k]);
  const float cosine = p.a[j] * p.a[k] + p.b[j] * p.b[k] + p.z[j] * p.z[k];
  return cosine >= kCosine &&
         std::abs(off) <= kOffPlane + kOffFar * static_cast<float>(std::max(std::abs(dx), std::abs(dy)));
}

/// The surface of the pure pixel nearest to i that is not on the surface of pixel `other` (-1: of none),
/// which is at (ox, oy). Returns that pixel, with its position in x, y; -1: there is none.
inline int nearestPart(const WaveletPlanes& p, int i, int other, int ox, int oy, int& x, int& y) {
  int found = -1, least = 1 << 20;
  eachPure(p, i, [&](int j, int dx, int dy) {
    const int square = dx * dx + dy * dy;
    if (square >= least || (other >= 0 && showOneSurface(p, other, j, dx - ox, dy - oy))) return;
    found = j, least = square, x = dx, y = dy;
  });
  return found;
}

inline MixedPart partOf(const WaveletPlanes& p, int i, int set, int seed, int sx, int sy) {
  constexpr float kSteepest = 0.05f;  // relative change; rims of round surfaces end before
  MixedPart part;
  eachPure(p, i, [&](int j, int dx, int dy) {
    if (!showOneSurface(p, seed, j, dx - sx, dy - sy)) return;
    const auto x = static_cast<float>(dx), y = static_cast<float>(dy);
    const float w = p.cover[j] * nearness(dx, dy);
    const float there = p.c[j] < 0 ? 1 + (p.a[j] * x + p.b[j] * y) / -p.c[j] : 1;
    const float distance = p.distance[j] / p.distance[i] / std::clamp(there, 1 - kSteepest, 1 + kSteepest);
    part.add({p.light[set][0][j], p.light[set][1][j], p.light[set][2][j]}, featuresAt(p, j, distance), w);
  });
  part.finish();
  return part;
}

/// Which part of pixel i shows `one` and not `two`, by its mean features; below 0: they do not explain it.
/// Features count in proportion to their precision: normals vary on round surfaces, reflectance under
/// textures.
inline float shareOf(const WaveletPlanes& p, int i, const MixedPart& one, const MixedPart& two) {
  constexpr float kUnexplained = 0.3f;  // of the difference of both parts
  constexpr float kVariance = 4e-4f;    // of features that do not vary
  const PartFeatures mixed = featuresAt(p, i, 1);
  const auto sum = [&](const auto& term) {
    float total = 0;
    for (int k = 0; k < PartFeatures::kCount; ++k) {
      const float difference = one.mean.value[k] - two.mean.value[k],
                  off = mixed.value[k] - two.mean.value[k];
      total += term(difference, off) / (one.variance.value[k] + two.variance.value[k] + kVariance);
    }
    return total;
  };
  const float square = sum([](float difference, float) { return difference * difference; });
  if (!(square > 1)) return -1;
  const float along = sum([](float difference, float off) { return difference * off; });
  const float share = std::clamp(along / square, 0.0f, 1.0f);
  const float rest = sum([&](float difference, float off) {
    const float left = off - share * difference;
    return left * left;
  });
  return rest <= kUnexplained * kUnexplained * square ? share : -1;
}

/// Replaces the light of pixel i, which mixes surfaces: by the light of its two nearest surfaces, in the
/// parts that its features tell; as far as its own `noisy` light with this variance allows. Light of pure
/// pixels is read from `set`.
inline void unmix(const WaveletPlanes& p, int i, int set, const float* noisy, float variance, float* light) {
  constexpr float kDeviations = 64;  // squared: eight; half counts at four
  int x = 0, y = 0, u = 0, v = 0;
  const int first = nearestPart(p, i, -1, 0, 0, x, y);
  const int second = first < 0 ? -1 : nearestPart(p, i, first, x, y, u, v);
  if (second < 0) return;
  const MixedPart one = partOf(p, i, set, first, x, y), two = partOf(p, i, set, second, u, v);
  const float share = shareOf(p, i, one, two);
  if (share < 0) return;
  glm::vec3 mixed;
  for (int c = 0; c < 3; ++c) {
    const float a = share * one.reflectance(c), b = (1 - share) * two.reflectance(c);
    mixed[c] = (a * one.light[c] + b * two.light[c]) / (a + b);
  }
  const glm::vec3 weights(0.2126f, 0.7152f, 0.0722f);
  const float off = glm::dot(weights, mixed - glm::vec3(noisy[0], noisy[1], noisy[2]));
  const float left = std::max(1 - off * off / (kDeviations * variance + 1e-12f), 0.0f);
  for (int c = 0; c < 3; ++c) light[c] += left * left * (mixed[c] - light[c]);
}

/// Mean light of the shadow catcher around pixel i. Returns whether there is any.
inline bool catcherLight(const WaveletPlanes& p, int i, int set, float& light) {
  float sum = 0, weights = 0;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const int j = i + dy * kStride + dx;
      if (!(p.distance[j] > 0) || p.red[0][j] != WaveletPlanes::kOnCatcher) continue;
      sum += nearness(dx, dy) * p.light[set][0][j], weights += nearness(dx, dy);
    }
  light = weights > 0 ? sum / weights : 0;
  return weights > 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif

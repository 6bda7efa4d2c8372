#include "render/bsdf/ggx_energy.h"

#include <array>

namespace gluray::render::bsdf {
namespace {

constexpr int kCosines = 48, kAlphas = 24;

float radicalInverse(uint32_t i) {
  uint32_t x = i;
  x = x << 16 | x >> 16;
  x = (x & 0x00ff00ffu) << 8 | (x & 0xff00ff00u) >> 8;
  x = (x & 0x0f0f0f0fu) << 4 | (x & 0xf0f0f0f0u) >> 4;
  x = (x & 0x33333333u) << 2 | (x & 0xccccccccu) >> 2;
  x = (x & 0x55555555u) << 1 | (x & 0xaaaaaaaau) >> 1;
  return static_cast<float>(x >> 8) * 0x1p-24f;
}

GgxAlbedo integrated(float cosine, const Ggx& ggx) {
  constexpr uint32_t kSamples = 1024;
  const glm::vec3 wo(std::sqrt(std::max(1 - cosine * cosine, 0.0f)), 0, cosine);
  double white = 0, bias = 0;
  for (uint32_t i = 0; i < kSamples; ++i) {
    const glm::vec2 u((static_cast<float>(i) + 0.5f) / kSamples, radicalInverse(i));
    const glm::vec3 h = ggx.visible(wo, u), wi = reflected(wo, h);
    if (wi.z <= 0) continue;
    const float away = 1 - std::min(std::max(glm::dot(wo, h), 0.0f), 1.0f), away2 = away * away;
    const double share = double{ggx.seen(wo, wi)} / double{ggx.seen(wo)};
    white += share, bias += share * double{away2 * away2 * away};
  }
  return {static_cast<float>((white - bias) / kSamples), static_cast<float>(bias / kSamples)};
}

/// Cosines are denser at grazing angles, roughnesses (square roots of alpha) even.
float cosineOf(int i) {
  const float x = static_cast<float>(i) / (kCosines - 1);
  return std::max(x * x, 1e-4f);
}
float alphaOf(int i) {
  const float roughness = static_cast<float>(i) / (kAlphas - 1);
  return std::max(roughness * roughness, 1e-4f);
}

struct Table {
  std::array<std::array<GgxAlbedo, kCosines>, kAlphas> albedo;
  std::array<GgxAlbedo, kAlphas> mean;
  Table() {
    for (int a = 0; a < kAlphas; ++a) {
      for (int c = 0; c < kCosines; ++c) albedo[a][c] = integrated(cosineOf(c), {alphaOf(a)});
      mean[a] = meanOf(a);
    }
  }
  /// 2 times the integral of albedo * cosine over cosine, of what lies linearly between the entries.
  GgxAlbedo meanOf(size_t a) const {
    double scale = 0, bias = 0;
    constexpr int kSteps = 8;
    for (int c = 0; c + 1 < kCosines; ++c)
      for (int s = 0; s < kSteps; ++s) {
        const double x0 = (c + double(s) / kSteps) / (kCosines - 1),
                     x1 = (c + double(s + 1) / kSteps) / (kCosines - 1);
        const double middle = (s + 0.5) / kSteps, weight = x1 * x1 * x1 * x1 - x0 * x0 * x0 * x0;
        const GgxAlbedo &p = albedo[a][c], &q = albedo[a][c + 1];
        scale += weight * (p.scale + middle * (q.scale - p.scale));
        bias += weight * (p.bias + middle * (q.bias - p.bias));
      }
    return {static_cast<float>(scale), static_cast<float>(bias)};
  }
};

const Table& table() {
  static const Table made;
  return made;
}

GgxAlbedo mix(const GgxAlbedo& a, const GgxAlbedo& b, float t) {
  return {a.scale + t * (b.scale - a.scale), a.bias + t * (b.bias - a.bias)};
}

/// The entry below x * (count - 1), and the way to the next.
struct At {
  size_t i;
  float rest;
  At(float x, int count) {
    const float scaled = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(count - 1);
    i = std::min(static_cast<size_t>(scaled), static_cast<size_t>(count - 2));
    rest = scaled - static_cast<float>(i);
  }
};

}  // namespace

GgxAlbedo ggxAlbedo(float cosine, float alpha) {
  const At c(std::sqrt(std::max(cosine, 0.0f)), kCosines), a(std::sqrt(alpha), kAlphas);
  const auto& rows = table().albedo;
  return mix(mix(rows[a.i][c.i], rows[a.i][c.i + 1], c.rest),
             mix(rows[a.i + 1][c.i], rows[a.i + 1][c.i + 1], c.rest), a.rest);
}

GgxAlbedo ggxMeanAlbedo(float alpha) {
  const At a(std::sqrt(alpha), kAlphas);
  return mix(table().mean[a.i], table().mean[a.i + 1], a.rest);
}

}  // namespace gluray::render::bsdf

// The wavelet filter from its definition, for tests.
#pragma once
#include "render/resolve/feature_pixels.h"
#include "render/resolve/wavelet.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace gluray::test {

/// The filter once more, pixel by pixel, from its definition.
class ReferenceWavelet {
 public:
  explicit ReferenceWavelet(const render::NoisyImage& in)
      : in_(in), pixels_(static_cast<size_t>(in.width * in.height)) {
    for (size_t i = 0; i < pixels_.size(); ++i) unpack(i);
  }
  std::vector<float> smooth() {
    smoothVariances();
    const std::vector<Pixel> before = pixels_;
    for (int step = 1; step <= 4; step *= 2) round(step);
    std::vector<float> out;
    for (size_t i = 0; i < pixels_.size(); ++i) {
      const glm::dvec3 r = before[i].reflectance;
      const double scale = std::max({r.x, r.y, r.z}), square = before[i].variance * scale * scale;
      const double share =
          before[i].shows && square > 0 ? std::max(1 - in_.target * in_.target / square, 0.0) : 0;
      const double own = in_.color[4 * i];
      out.push_back(static_cast<float>(own + (share > 0 ? share * (pixels_[i].light.x * r.x - own) : 0)));
    }
    return out;
  }

 private:
  struct Pixel {
    bool shows = false;
    glm::dvec3 reflectance{0}, light{0}, normal{0};
    double facing = 0, distance = 0, variance = 0;
  };
  void unpack(size_t i) {
    Pixel& p = pixels_[i];
    p.distance = in_.features.distance[i], p.shows = p.distance > 0;
    if (!p.shows) return;
    p.reflectance = render::unpackReflectance(in_.features.reflectance[i]),
    p.facing = render::unpackFacing(in_.features.facing[i]);
    const glm::dvec2 n = render::unpackNormal2(in_.features.normal[i]);
    p.normal = {n, std::sqrt(std::max(1 - glm::dot(n, n), 0.0))};
    for (int c = 0; c < 3; ++c) p.light[c] = in_.color[4 * i + static_cast<size_t>(c)] / p.reflectance[c];
    const double error = in_.noise[i] / double{render::kNoiseOne};
    p.variance = std::pow(error / std::max({p.reflectance.x, p.reflectance.y, p.reflectance.z}), 2);
  }
  static double biweight(double x) { return x < 1 ? (1 - x) * (1 - x) : 0; }
  static double luminance(const Pixel& p) { return glm::dot(p.light, glm::dvec3(0.2126, 0.7152, 0.0722)); }
  static double likeness(const Pixel& p, const Pixel& q, int dx, int dy) {
    if (!p.shows || !q.shows) return 0;
    const double off = p.normal.x * dx + p.normal.y * dy + p.facing * (1 - p.distance / q.distance);
    const double end = 0.75 + 0.09 * std::max({std::abs(dx), std::abs(dy), 1});
    const glm::dvec3 d = glm::abs(p.reflectance - q.reflectance);
    return biweight(off * off / (end * end)) *
           std::pow(std::clamp(glm::dot(p.normal, q.normal), 0.0, 1.0), 32) *
           biweight(std::pow(std::max({d.x, d.y, d.z}) / 0.1, 2));
  }
  /// Calls each(neighbour, likeness) for the 5 x 5 pixels that are inside.
  template <class Each>
  void around(size_t i, const Each& each) const {
    const int x = static_cast<int>(i) % in_.width, y = static_cast<int>(i) / in_.width;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const int u = x + dx, v = y + dy;
        if (u < 0 || v < 0 || u >= in_.width || v >= in_.height) continue;
        const Pixel& q = pixels_[static_cast<size_t>(v * in_.width + u)];
        each(q, likeness(pixels_[i], q, dx, dy));
      }
  }
  void smoothVariances() {
    std::vector<Pixel> next = pixels_;
    for (size_t i = 0; i < pixels_.size(); ++i) {
      double weights = 0, sum = 0;
      around(i, [&](const Pixel& q, double w) { weights += w, sum += w * q.variance; });
      next[i].variance = weights > 0 ? sum / weights : 0;
    }
    pixels_ = next;
  }
  /// A neighbour with its likeness times the kernel, 0 where it is outside.
  struct Neighbour {
    double like = 0, difference = 0;
    const Pixel* pixel = nullptr;
  };
  Neighbour neighbour(size_t i, int dx, int dy, double kernel) const {
    const int x = static_cast<int>(i) % in_.width + dx, y = static_cast<int>(i) / in_.width + dy;
    if (x < 0 || y < 0 || x >= in_.width || y >= in_.height) return {};
    const Pixel& q = pixels_[static_cast<size_t>(y * in_.width + x)];
    return {kernel * likeness(pixels_[i], q, dx, dy), luminance(q) - luminance(pixels_[i]), &q};
  }
  void round(int step) {
    constexpr double kernel[] = {3.0 / 8, 1.0 / 4, 1.0 / 16};
    std::vector<Pixel> next = pixels_;
    for (size_t i = 0; i < pixels_.size(); ++i) {
      const double limit = 50 * pixels_[i].variance + 1e-12;
      double weights = 0, variance = 0;
      glm::dvec3 light(0);
      const auto add = [&](const Pixel& q, double w) {
        weights += w, light += w * q.light, variance += w * w * q.variance;
      };
      if (pixels_[i].shows) add(pixels_[i], kernel[0] * kernel[0]);
      for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx) {
          if (dx == 0 && dy == 0) continue;
          const double k = kernel[std::abs(dx)] * kernel[std::abs(dy)];
          const Neighbour q = neighbour(i, dx * step, dy * step, k),
                          opposite = neighbour(i, -dx * step, -dy * step, k);
          if (!q.pixel) continue;
          const double bend = q.difference + opposite.difference,
                       both = std::min(q.like, opposite.like) * biweight(bend * bend / (4 * limit));
          add(*q.pixel, both + (q.like - both) * biweight(q.difference * q.difference / limit));
        }
      if (weights > 0) next[i].light = light / weights, next[i].variance = variance / (weights * weights);
    }
    pixels_ = next;
  }

  const render::NoisyImage& in_;
  std::vector<Pixel> pixels_;
};

}  // namespace gluray::test

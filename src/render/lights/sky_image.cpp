#include "render/lights/sky_image.h"

#include "render/bsdf/local_frame.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using bsdf::kPi;

/// From a direction to the image, and the sine of its angle to the zenith.
glm::vec2 placeOf(const glm::vec3& d, float& sine) {
  const float azimuth = std::atan2(d.z, d.x);
  sine = std::sqrt(d.x * d.x + d.z * d.z);
  float u = azimuth / (2 * kPi);
  if (u < 0) u += 1;
  return {std::min(u, 0x1.fffffep-1f), std::atan2(sine, d.y) / kPi};
}

glm::vec3 directionAt(const glm::vec2& place, float& sine) {
  const float azimuth = 2 * kPi * place.x, polar = kPi * place.y;
  sine = std::sin(polar);
  return {sine * std::cos(azimuth), std::cos(polar), sine * std::sin(azimuth)};
}

}  // namespace

SkyImage::SkyImage(SkyPixels pixels) : pixels_(std::move(pixels)) {
  constexpr float kMax = 1e6f;
  // The distribution's cells hold several pixels of a large image.
  constexpr int kMaxColumns = 2048, kMaxRows = 1024;
  const int columns = std::min(pixels_.width, kMaxColumns), rows = std::min(pixels_.height, kMaxRows);
  std::vector<float> weights(static_cast<size_t>(columns) * static_cast<size_t>(rows));
  for (size_t i = 0; i < pixels_.pixels.size(); ++i) {
    glm::vec3& c = pixels_.pixels[i];
    for (int k = 0; k < 3; ++k) c[k] = std::isfinite(c[k]) ? std::clamp(c[k], 0.0f, kMax) : 0;
    const auto w = static_cast<size_t>(pixels_.width), h = static_cast<size_t>(pixels_.height);
    const size_t column = i % w * static_cast<size_t>(columns) / w,
                 row = i / w * static_cast<size_t>(rows) / h;
    const float sine = std::sin(kPi * (static_cast<float>(row) + 0.5f) / static_cast<float>(rows));
    weights[row * static_cast<size_t>(columns) + column] += (c.x + c.y + c.z) * sine;
  }
  distribution_ = Distribution2D(weights, columns, rows);
}

/// Constant in each pixel, as the distribution is: bright pixels beside dark ones are drawn as they are seen.
glm::vec3 SkyImage::at(const glm::vec2& place) const {
  const int x =
      std::clamp(static_cast<int>(place.x * static_cast<float>(pixels_.width)), 0, pixels_.width - 1);
  const int y =
      std::clamp(static_cast<int>(place.y * static_cast<float>(pixels_.height)), 0, pixels_.height - 1);
  return pixels_.pixels[static_cast<size_t>(y) * static_cast<size_t>(pixels_.width) + static_cast<size_t>(x)];
}

glm::vec3 SkyImage::radiance(const glm::vec3& direction) const {
  float sine;
  return at(placeOf(direction, sine));
}

Environment::Arriving SkyImage::sample(const glm::vec2& u) const {
  float density, sine;
  const glm::vec2 place = distribution_.sample(u, density);
  const glm::vec3 direction = directionAt(place, sine);
  if (!(density > 0) || !(sine > 0)) return {};
  // The image covers 2 pi * pi of angles, and a part at the zenith less of the sphere.
  return {direction, at(place), density / (2 * kPi * kPi * sine)};
}

float SkyImage::pdf(const glm::vec3& direction) const {
  float sine;
  const glm::vec2 place = placeOf(direction, sine);
  return sine > 0 ? distribution_.pdf(place) / (2 * kPi * kPi * sine) : 0;
}

}  // namespace gluray::render

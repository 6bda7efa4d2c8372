// Environment light from a latitude-longitude image. Immutable once made; any thread.
#pragma once
#include "render/lights/distribution2d.h"
#include "render/lights/environment.h"

#include <string>
#include <vector>

namespace gluray::render {

/// Linear colours; the first row is the zenith. Column 0 begins at azimuth 0, where +x is; y is up; azimuth
/// grows to +z.
struct SkyPixels {
  int width = 0, height = 0;
  std::vector<glm::vec3> pixels;
};

class SkyImage {
 public:
  /// Values that are not finite count as 0; others are kept within 0 .. 1e6.
  explicit SkyImage(SkyPixels);
  glm::vec3 radiance(const glm::vec3& direction) const;
  Environment::Arriving sample(const glm::vec2&) const;
  float pdf(const glm::vec3& direction) const;

 private:
  glm::vec3 at(const glm::vec2& place) const;
  SkyPixels pixels_;
  Distribution2D distribution_;
};

/// A rotated and scaled sky image, in eye space.
class TurnedSky final : public Environment {
 public:
  /// `skyFromEye`: a rotation.
  TurnedSky(std::shared_ptr<const SkyImage> image, const glm::mat3& skyFromEye, float strength)
      : image_(std::move(image)), skyFromEye_(skyFromEye), strength_(strength) {}
  glm::vec3 radiance(const glm::vec3& direction) const noexcept override {
    return strength_ * image_->radiance(skyFromEye_ * direction);
  }
  bool isSampled() const noexcept override { return strength_ > 0; }
  Arriving sample(const glm::vec2& u) const noexcept override {
    Arriving a = image_->sample(u);
    a.direction = a.direction * skyFromEye_;  // by the transpose: the inverse
    a.radiance *= strength_;
    return a;
  }
  float pdf(const glm::vec3& direction) const noexcept override {
    return image_->pdf(skyFromEye_ * direction);
  }

 private:
  std::shared_ptr<const SkyImage> image_;
  glm::mat3 skyFromEye_;
  float strength_;
};

}  // namespace gluray::render

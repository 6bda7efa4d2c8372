// Analytic skies: a constant, a gradient from ground over horizon to zenith, or two hemispheres. Any thread.
#pragma once
#include "render/lights/environment.h"
#include "scene/light_source.h"

#include <cmath>

namespace gluray::render {

class Dome final : public Environment {
 public:
  explicit Dome(const glm::vec3& color) : ground_(color), horizon_(color), zenith_(color) {}
  /// `up`: unit length.
  Dome(const glm::vec3& ground, const glm::vec3& horizon, const glm::vec3& zenith, const glm::vec3& up)
      : ground_(ground), horizon_(horizon), zenith_(zenith), up_(up) {}
  glm::vec3 radiance(const glm::vec3& direction) const noexcept override {
    const float height = glm::dot(direction, up_);
    return glm::mix(horizon_, height < 0 ? ground_ : zenith_, std::min(std::abs(height), 1.0f));
  }

 private:
  glm::vec3 ground_, horizon_, zenith_, up_{0, 1, 0};
};

/// The sky and the ground of a light rig.
class RigSky final : public Environment {
 public:
  RigSky(const scene::Dome& dome, float strength)
      : up_(dome.up), sky_(strength * dome.sky), ground_(strength * dome.ground) {}
  glm::vec3 radiance(const glm::vec3& direction) const noexcept override {
    return glm::dot(direction, up_) > 0 ? sky_ : ground_;
  }

 private:
  glm::vec3 up_, sky_, ground_;
};

}  // namespace gluray::render

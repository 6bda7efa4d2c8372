// Light from all around a scene, from infinitely far. Made once a frame, asked on all tracing threads.
#pragma once
#include <glm/glm.hpp>

#include <memory>

namespace gluray::render {

class Environment {
 public:
  struct Arriving {
    glm::vec3 direction{0, 0, 1};  // unit length, towards the light
    glm::vec3 radiance{0};
    float pdf = 0;  // solid angle
  };
  virtual ~Environment() = default;
  /// Radiance from a direction of unit length; finite, not negative.
  virtual glm::vec3 radiance(const glm::vec3& direction) const noexcept = 0;
  /// Whether sample() has a use: false where every direction is about as bright as all others.
  virtual bool isSampled() const noexcept { return false; }
  /// A direction, drawn about in proportion to its brightness, by two numbers in [0, 1).
  virtual Arriving sample(const glm::vec2&) const noexcept { return {}; }
  /// Density of sample().
  virtual float pdf(const glm::vec3&) const noexcept { return 0; }
};

}  // namespace gluray::render

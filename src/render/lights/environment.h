// Environment light, infinitely far away. Made once a frame, called on all tracing threads.
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
  /// Whether sample() is useful; false if all directions are about equally bright.
  virtual bool isSampled() const noexcept { return false; }
  /// Samples a direction about in proportion to brightness, from two numbers in [0, 1).
  virtual Arriving sample(const glm::vec2&) const noexcept { return {}; }
  /// Probability density of sample().
  virtual float pdf(const glm::vec3&) const noexcept { return 0; }
};

}  // namespace gluray::render

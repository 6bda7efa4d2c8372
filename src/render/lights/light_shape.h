// Shapes of lights of rigs and files, for sampling and intersection in path tracing. Made once a frame,
// called on all tracing threads.
#pragma once
#include "scene/light_source.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::render {

/// A light in eye space, and its shape:
/// - distant: a cone of directions;
/// - point, spot: a ball with the light of the point: a surface that faces it has the light's colour after
///   attenuation and cone, for any size of the ball;
/// - sphere: emits outwards, and to points inside from all sides;
/// - rectangle, disc: emit to the side of their direction only; rays from behind do not hit them.
class LightShape {
 public:
  struct Arriving {
    glm::vec3 direction{0, 0, 1};  // unit length, towards the light
    float distance = 0;            // infinite of distant lights
    /// Radiance / density; its expectation is the irradiance of a surface that faces the light.
    glm::vec3 irradiance{0};
    float pdf = 0;  // density over solid angle; 0: a light without size, which random rays cannot hit
  };
  struct Met {
    float distance, pdf;
    glm::vec3 radiance;
  };

  /// `size`: angular diameter in degrees of lights without a size of their own; 0: no size.
  LightShape(const scene::LightSource&, float size);
  bool isVisible() const { return light_.visible; }
  /// Samples the light that arrives at a point, with u in [0, 1)^2. Black if none arrives.
  Arriving sample(const glm::vec3& point, const glm::vec2& u) const;
  /// Intersects a ray from the point with the light; returns the hit and the density of sample(). None for
  /// lights whose sample() has no density.
  std::optional<Met> meet(const glm::dvec3& point, const glm::dvec3& direction) const;
  /// Colour of the light itself, if it is visible.
  glm::vec3 shown() const { return glm::vec3(color_); }
  /// Estimates the mean irradiance of sample() times the cosine to `normal`; not 0 if light arrives on that
  /// side. `normal` may be null: all sides.
  glm::vec3 estimate(const glm::vec3& point, const glm::vec3* normal) const;

 private:
  struct Cone;
  Cone coneFrom(const glm::dvec3& point) const;
  Arriving sampleCone(const glm::dvec3& point, const glm::vec2& u) const;
  Arriving sampleArea(const glm::dvec3& point, const glm::vec2& u) const;
  std::optional<Met> meetCone(const glm::dvec3& point, const glm::dvec3& direction) const;
  std::optional<Met> meetArea(const glm::dvec3& point, const glm::dvec3& direction) const;
  bool isArea() const;

  scene::LightSource light_;
  double sineOfSize_;  // of half the angle of lights without a size of their own
  glm::dvec3 color_, middle_, direction_;
  double area_ = 0, reach_ = 0;  // of rectangles and discs; reach: of the ball around them
};

}  // namespace gluray::render

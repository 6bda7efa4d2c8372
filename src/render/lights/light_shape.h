// Lights of rigs and files as paths meet them: from a point, each fills a part of the directions. Made once a
// frame, asked on all tracing threads.
#pragma once
#include "scene/light_source.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::render {

/// A light in eye space, and its shape:
/// - distant: a cone of directions;
/// - point, spot: a ball whose light is that of the point: the surface that faces it shows the light's colour
///   after attenuation and cone, however large the ball is;
/// - sphere: shines outwards, and fills its inside with its light;
/// - rectangle, disc: shine to the side of their direction; from behind they are not there.
class LightShape {
 public:
  struct Arriving {
    glm::vec3 direction{0, 0, 1};  // unit length, towards the light
    float distance = 0;            // infinite of distant lights
    glm::vec3 irradiance{0};  // radiance / density: its mean is the irradiance of a surface that faces it
    float pdf = 0;  // density over solid angle; 0: the light is so small that no ray meets it by chance
  };
  struct Met {
    float distance, pdf;
    glm::vec3 radiance;
  };

  /// `size`: how wide a light appears that has no size of its own, degrees; 0: it stays without one.
  LightShape(const scene::LightSource&, float size);
  bool isVisible() const { return light_.visible; }
  /// The light that arrives at a point along a direction drawn by u, in [0, 1)^2. Black: none.
  Arriving sample(const glm::vec3& point, const glm::vec2& u) const;
  /// Where a ray from the point meets the light, and the density of sample() there. Nothing for lights whose
  /// sample() has no density.
  std::optional<Met> meet(const glm::dvec3& point, const glm::dvec3& direction) const;
  /// What the viewer sees of it where it is visible.
  glm::vec3 shown() const { return glm::vec3(color_); }
  /// About what sample()'s irradiance is in the mean, times the cosine to `normal`; not 0 where some light
  /// arrives on its side. Null: from all sides.
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

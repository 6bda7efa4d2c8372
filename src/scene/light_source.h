// Common representation of lights for light transport: lights of fixed function, shader programs, rigs and
// files are converted to it. Plain data.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::scene {

/// A light in the eye space of the view. Lengths are in eye-space units.
///
/// Its colour times its strength is
/// - distant, point, spot: irradiance / pi, the value of a white diffuse surface that faces it, before
/// attenuation and cone;
/// - rectangle, disc, sphere: its radiance, the value of a white diffuse surface whose hemisphere it fills.
struct LightSource {
  enum class Kind : uint8_t { distant, point, spot, rectangle, disc, sphere };
  Kind kind = Kind::distant;
  glm::vec3 color{1};  // linear factor of the surface's colours, not negative
  float strength = 1;
  glm::vec3 position{0};          // all but distant; of areas and spheres the centre
  glm::vec3 direction{0, 0, -1};  // distant, spot, rectangle, disc: the way the light travels, unit length
  float angle = 0;                // distant: angular diameter, degrees; 0: no size of its own
  float radius = 0;               // point, spot: of the emitting ball, 0: none; disc, sphere: > 0
  glm::vec3 halfEdge[2] = {{1, 0, 0}, {0, 1, 0}};  // rectangle: from its centre to the middles of two edges
  glm::vec3 attenuation{1, 0, 0};                  // point, spot: 1 / (x + y*d + z*d*d) at distance d
  float coneCosine = -1;                           // spot: no light where the cosine to its direction is less
  float coneExponent = 0;                          // spot: power of that cosine
  bool visible = false;                            // rays that hit it show it
  bool operator==(const LightSource&) const = default;
};

/// Light from two hemispheres, the sky above and the ground below, each of constant radiance.
struct Dome {
  glm::vec3 up{0, 1, 0};  // eye space, unit length
  glm::vec3 sky{0}, ground{0};
  bool shines() const { return sky != glm::vec3(0) || ground != glm::vec3(0); }
  bool operator==(const Dome&) const = default;
};

}  // namespace gluray::scene

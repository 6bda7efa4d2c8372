// Evaluates the lights of the program, or a rig's light at the viewer, for light transport. Made once a
// frame, called on all tracing threads.
#pragma once
#include "render/frame_data/frame_data.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::render {

/// One light as it reaches a point.
struct ArrivingLight {
  glm::vec3 direction{0, 0, 1};  // unit length, towards the light, eye space
  float distance = 0;            // infinite of directional lights
  /// The light's colour after attenuation and cone: the value of a white diffuse surface that faces the
  /// light.
  glm::vec3 color{0};
  glm::vec3 specular{0};  // specular colour after attenuation and cone
  bool atViewer = false;  // a headlight: visible surfaces are always lit
};

/// The lights of each surface by its own state or program. AddedLights has the lights of settings.
class ShadingLights {
 public:
  explicit ShadingLights(const FrameData& frame);
  uint32_t countOf(uint32_t instance) const { return counts_[instance]; }
  /// Light `index` of the surface at an eye-space point of it.
  ArrivingLight at(uint32_t instance, uint32_t index, const glm::vec3& point) const;
  /// Highlight of a light from at() by the surface's equation, without the material's colour. `toViewer`:
  /// unit length.
  glm::vec3 highlight(uint32_t instance, uint32_t index, const ArrivingLight&, const glm::vec3& normal,
                      const glm::vec3& toViewer, float shininess) const;
  /// Highlight of a white light that is not at the viewer. `direction`: towards the light, unit length.
  float highlight(uint32_t instance, const glm::vec3& direction, const glm::vec3& normal,
                  const glm::vec3& toViewer, float shininess) const;

 private:
  /// `ahead`: the light is the program's headlight.
  float highlight(uint32_t instance, bool ahead, const glm::vec3& direction, const glm::vec3& normal,
                  const glm::vec3& toViewer, float shininess) const;

  const std::vector<Surface>& surfaces_;
  std::vector<uint32_t> counts_;            // lights of each surface
  std::vector<glm::mat4> lightingFromEye_;  // for surfaces of shader programs
};

}  // namespace gluray::render

// The lights of a frame that cast visible shadows, and their indices among the lights of each surface. Made
// once a frame, read by every tracing thread.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/integrators/metric.h"
#include "scene/light_source.h"

#include <vector>

namespace gluray::render {

/// Light `r` has row `r` of Visibility::lights.
struct ShadowLights {
  /// The row of each light of a surface; -1 for lights without shadows.
  struct Rows {
    std::vector<int8_t> ofLight;
    int8_t ofDome = -1;
    uint32_t used = 0;  // bit r: row r is used
    glm::vec3 up{0};    // of the dome, in the surface's lighting space; 0: no dome
    glm::mat3 eyeFromLighting{1};
    bool operator==(const Rows&) const = default;
  };
  std::vector<scene::LightSource> lights;  // eye space; the entry of the dome is unused
  // For each light: the instances that represent the lamp itself, and do not block its light. Sorted.
  std::vector<std::vector<uint32_t>> lamps;
  int dome = -1;  // its row; -1: it has no shadow
  std::vector<Rows> rows;
  std::vector<uint32_t> rowsOfInstance;  // indices of `rows`
  const Rows& rowsOf(uint32_t instance) const { return rows[rowsOfInstance[instance]]; }
};

/// Returns the instances that represent the lamp of a light at `light` (eye space), and do not block its
/// light. Sorted.
std::vector<uint32_t> lampsOf(const FrameData&, const Metric&, const glm::vec3& light);

/// Finds the strongest lights, at most kShadowLights; logs one line if there are more. `casts`: if false, no
/// light but the dome is included.
ShadowLights findShadowLights(const FrameData&, const Metric&, bool casts);

}  // namespace gluray::render

// The lights of a frame whose shadows the viewer can see, and which of each surface's lights they are. Made
// once a frame, read by every tracing thread.
#pragma once
#include "render/frame_data/frame_data.h"
#include "render/integrators/metric.h"
#include "scene/light_source.h"

#include <vector>

namespace gluray::render {

/// Row `r` of Factors::visibility is of light `r`.
struct ShadowLights {
  /// For the lights of a surface: the row, or -1 for those without a shadow.
  struct Rows {
    std::vector<int8_t> ofLight;
    int8_t ofDome = -1;
    uint32_t used = 0;  // bit r: row r is there
    glm::vec3 up{0};    // of the dome, in the space of the surface's lighting; 0: none shines on it
    glm::mat3 eyeFromLighting{1};
    bool operator==(const Rows&) const = default;
  };
  std::vector<scene::LightSource> lights;  // eye space; that of the dome has no meaning
  // Of each light: the instances that show where it is, and so do not hide it. Sorted.
  std::vector<std::vector<uint32_t>> lamps;
  int dome = -1;  // its row; -1: it has no shadow
  std::vector<Rows> rows;
  std::vector<uint32_t> rowsOfInstance;  // indices of `rows`
  const Rows& rowsOf(uint32_t instance) const { return rows[rowsOfInstance[instance]]; }
};

/// The frame's instances that show where a light at `light` (eye space) is, and so do not hide it. Sorted.
std::vector<uint32_t> lampsOf(const FrameData&, const Metric&, const glm::vec3& light);

/// At most kShadowLights, the strongest ones; logs one line where there are more. `casts`: false leaves out
/// all shadows; the dome shines anyway.
ShadowLights findShadowLights(const FrameData&, const Metric&, bool casts);

}  // namespace gluray::render

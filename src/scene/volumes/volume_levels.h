// How scalars become colours where one map has both colours and opacities. Plain data.
#pragma once
#include <glm/glm.hpp>

#include <limits>
#include <vector>

namespace gluray::scene {

/// Of the blends of a Volume that take a map: scalars are clamped to `limits`, which become 0 and 1, and
/// raised to `gamma`; there the map is read, whose first and last entries lie at 0 and 1.
struct VolumeLevels {
  glm::vec2 limits{0, 1};  // unequal; the first may be the larger one
  float gamma = 1;
  float leastMaximum = -std::numeric_limits<float>::max();  // rays whose maximum is not above it show nothing
  float mostMinimum = std::numeric_limits<float>::max();    // likewise, not below it
  float attenuation = 1;
  float attenuationStep = 1;      // what a sample counts
  float threshold = 0;            // of surfaces
  float opacity = 1;              // factor of what is shown
  std::vector<glm::vec4> planes;  // texture space: samples count where no dot(plane, (p, 1)) is below 0
};

/// Rays from the front of a box, or the near plane, to the faces: each is cut into equal steps.
struct VolumeSpan {
  glm::dvec3 size{1};  // of the box, in data space: from -0.5 to size - 0.5
  double step = 1;     // data space: rays have as many steps as such lengths, rounded
  double shift = 0;    // texture coordinates are those of data space plus this, divided by the size
  /// Homogeneous: where the straight line through a point on which rays go meets the near and far planes.
  glm::dmat4 nearFromData{1}, farFromData{1};
  /// The depth of what is shown is z / w of this, 0 .. 1 of -1 .. 1; otherwise it is that of the face.
  bool showsDepth = false;
  glm::dmat4 depthFromData{1};
  glm::dvec4 window{-1e30, 1e30, -1e30,
                    1e30};  // least and greatest x, least and greatest y of pixels' centres
};

}  // namespace gluray::scene

// The channels of Visibility that a visibility buffer stores: the used ones, with grey visibility stored
// once. Any thread.
#pragma once
#include "render/integrators/light_visibility.h"

#include <algorithm>

namespace gluray::render {

struct Channels {
  static constexpr int kMax = 1 + 3 * kShadowLights;

  UsedVisibility used;
  int perLight() const { return used.colored ? 3 : 1; }
  int count() const { return (used.occlusion ? 1 : 0) + used.lights * perLight(); }
  Row& rowOf(Visibility& visibility, int channel) const {
    if (used.occlusion && channel-- == 0) return visibility.occlusion;
    return visibility.lights[channel / perLight()][channel % perLight()];
  }
  const Row& rowOf(const Visibility& visibility, int channel) const {
    return rowOf(const_cast<Visibility&>(visibility), channel);
  }
  /// Copies grey visibility to its other two rows.
  void spread(Visibility& visibility) const {
    for (int light = 0; light < used.lights && !used.colored; ++light)
      for (int c = 1; c < 3; ++c)
        std::copy_n(visibility.lights[light][0], kLanes, visibility.lights[light][c]);
  }
  bool operator==(const Channels&) const = default;
};

}  // namespace gluray::render

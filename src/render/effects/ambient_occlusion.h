// Ambient occlusion: surfaces that hide the sky above a point darken the point.
#pragma once
#include "render/integrators/light_visibility.h"
#include "render/integrators/metric.h"
#include "render/integrators/occluders.h"

#include <algorithm>

namespace gluray::render {

/// The unoccluded part of the hemisphere above a point,
///   A = 1 - strength/pi * integral of (1 - V(w)) cos(n, w) dw,  V = 0 where something lies within `radius`.
/// Directions are drawn in proportion to the cosine, so that the estimate is 1 - strength * blocked /
/// samples. Source: Zhukov, Iones, Kronin, "An Ambient Light Illumination Model", 1998.
struct AmbientOcclusion {
  AmbientOcclusion(const FrameData&, const Metric&, const Occluders&);
  /// Fills Visibility::occlusion.
  void estimate(const AskedPoints&, Visibility&) const noexcept;

  const FrameData& frame;
  const Metric& metric;
  const Occluders& occluders;
  int samples;     // rays a point, >= 1; noise falls as 1/sqrt(samples)
  float radius;    // eye space
  float strength;  // 0: no effect, 1: full
  bool interreflects;

  /// The fraction of light that arrives where `seen` of the hemisphere is unoccluded, with what surfaces of
  /// this reflectance around the point reflect. Source: Jimenez, Wu, Pesce, Jarabo, "Practical Real-Time
  /// Strategies for Accurate Indirect Occlusion", 2016, section 5.
  static float withReflections(float seen, float reflectance) {
    const float a = 2.0404f * reflectance - 0.3324f, b = -4.7951f * reflectance + 0.6417f,
                c = 2.7552f * reflectance + 0.6903f;
    return std::max(seen, ((seen * a + b) * seen + c) * seen);
  }
};

}  // namespace gluray::render

// The integrators' rays a second against those of a bare Embree loop with as many rays.
#pragma once
#include "bench/light/stage.h"

namespace gluray::bench {

struct ComparedRays {
  double ours = 0, bare = 0;  // a second
};
enum class RayUse { occlusion, shadow };

/// Ours: frames with more rays a pixel, less those with one. Shadows are those of the key light
/// (lights=headlight+key).
ComparedRays compareRays(Stage&, RayUse, int threads, int rounds);

}  // namespace gluray::bench

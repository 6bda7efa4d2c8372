// Cost of one traced snapshot, passed from the renderer through the presenter to the report. Plain data.
#pragma once
#include "scene/failure.h"

#include <cstdint>

namespace gluray::scene {

struct TraceCost {
  double buildSeconds = 0, traceSeconds = 0;
  uint64_t blasBuilds = 0, tlasBuilds = 0;  // acceleration structures that the tracing waited for
  uint64_t blasRefinements = 0;             // fast BLASes replaced by full ones, built in the background
  uint64_t bvhBytes = 0;                    // of all acceleration structures at present
  bool blasRefining = false;                // a full BLAS is being built
  // Another process makes the image, so that no passes follow. `refined`: it is finished.
  bool elsewhere = false, refined = false;
  Loss loss = Loss::tracing;  // if the snapshot could not be traced
};

}  // namespace gluray::scene

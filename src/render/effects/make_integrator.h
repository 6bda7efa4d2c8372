// Chooses the integrator of a frame. Called once a frame, on the calling thread.
#pragma once
#include "render/integrators/integrator.h"

#include <memory>

namespace gluray::render {

/// Makes the integrator of the snapshot's settings; null if only the local look is used.
std::unique_ptr<const Integrator> makeIntegrator(const FrameData&);

}  // namespace gluray::render

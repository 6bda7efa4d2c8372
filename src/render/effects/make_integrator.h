// Which light beyond the local look a frame gets. Asked once a frame, on the calling thread.
#pragma once
#include "render/integrators/integrator.h"

#include <memory>

namespace gluray::render {

/// The integrator that the snapshot's settings ask for; null where they ask for the local look alone.
std::unique_ptr<const Integrator> makeIntegrator(const FrameData&);

}  // namespace gluray::render

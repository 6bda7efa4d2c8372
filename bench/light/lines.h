// Lines as tubes, for the light benchmark.
#pragma once
#include "scene/mesh.h"

namespace gluray::bench {

/// The pieces of so many magnetic field lines of the paper's star, at most 60 each, as capsules.
scene::MeshPtr fieldLines(int count);

}  // namespace gluray::bench

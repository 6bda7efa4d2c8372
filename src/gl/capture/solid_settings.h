// Tests whether settings replace lines and points by solids: tubes and spheres.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "settings/settings.h"

namespace gluray::gl {

/// Whether settings turn draws of this class into solids.
bool drawsSolids(const Settings& settings, PrimitiveClass kind);

/// Whether settings turn draws of any class into solids.
bool drawsAnySolids(const Settings& settings);

}  // namespace gluray::gl

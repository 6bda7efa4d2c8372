// Texture environments: how texels and colours become the fragment's colour. Called on tracing threads.
#pragma once
#include "scene/texture.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// What the units of one fragment have to combine.
struct CombineInputs {
  glm::vec4 texels[scene::kTextureUnits];  // by unit; those of units that are off have no meaning
  glm::vec4 primary{1};                    // the colour before texturing
};

/// The colour that comes from the unit of texture `t`, whose predecessor gave `previous`; not yet clamped.
/// GL 2.1, tables 3.22 to 3.26.
glm::vec4 applyEnvironment(const scene::Texture& t, const CombineInputs&, glm::vec4 previous);

}  // namespace gluray::render

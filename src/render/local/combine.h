// Texture environments: combine texels and colours into the fragment's colour. Called on tracing threads.
#pragma once
#include "scene/texture.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// Inputs of one fragment's texture environments.
struct CombineInputs {
  glm::vec4 texels[scene::kTextureUnits];  // per unit; undefined for disabled units
  glm::vec4 primary{1};                    // the colour before texturing
};

/// The unclamped result of texture `t`'s unit; `previous` is the preceding unit's. GL 2.1, tables 3.22
/// to 3.26.
glm::vec4 applyEnvironment(const scene::Texture& t, const CombineInputs&, glm::vec4 previous);

}  // namespace gluray::render

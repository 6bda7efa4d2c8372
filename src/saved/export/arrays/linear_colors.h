// Displayed colours as linear light, which glTF has. Any thread.
#pragma once
#include "saved/export/arrays/array_source.h"

#include <glm/glm.hpp>

namespace gluray::saved {

/// Linear light of a displayed colour; alpha is unchanged.
glm::vec4 linearOf(const glm::vec4& displayed);

/// Linear light of vertex colours: bytes4 becomes shorts4, which tells all bytes apart; float4 stays.
SourcePtr linearColors(const SourcePtr&);

}  // namespace gluray::saved

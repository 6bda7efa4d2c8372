// Where a shader program's vertices come from: attributes, or buffer textures (FamilyPulling). Any thread.
#pragma once
#include "gl/families/family.h"
#include "gl/glsl/program.h"

#include <string>

namespace gluray::gl {

/// Whether the shader program has the input `name` with a value for each vertex; not if `name` is empty.
inline bool hasVertexInput(const Program& program, const Family& family, const std::string& name) {
  if (name.empty()) return false;
  return family.pulling.given() ? program.uniform(name) != nullptr : program.attribute(name) != nullptr;
}

}  // namespace gluray::gl

// All queryable OpenGL state, as a table that can be compared.
#pragma once
#include "gl/real/real.h"

#include <map>
#include <string>
#include <vector>

namespace gluray::test {

/// "unit 3 TEXTURE_BINDING_2D" -> values. Names that the context does not know are absent.
using GlState = std::map<std::string, std::vector<double>>;

/// Queries every name of the registry that belongs to a state query: glGet (plain and indexed),
/// glIsEnabled, texture units and the textures bound there, lights, materials, clip planes, vertex arrays,
/// pixel maps, framebuffer attachments. Pending errors are lost; nothing else changes.
GlState queryState(const gl::RealGl& gl);

/// One line for each name whose values differ: "DEPTH_FUNC: 513 -> 515".
std::vector<std::string> differences(const GlState& before, const GlState& after);

}  // namespace gluray::test

// Resolves the conditions of GLSL's preprocessor, for families with match.resolve_conditions. Any thread.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace gluray::gl {

/// A shader's text without comments and without the lines that #if, #ifdef, #ifndef, #elif and #else exclude.
/// Definitions that the rest does not use are left out, too. Returns nullopt if the text ends within a
/// condition, or if a condition tests more than which names are defined, 0 and 1, or tests names that OpenGL
/// itself defines (GL_..., __VERSION__).
std::optional<std::string> resolveConditions(std::string_view text);

}  // namespace gluray::gl

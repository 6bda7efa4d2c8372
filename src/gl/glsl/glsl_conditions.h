// Resolves the conditions of GLSL's preprocessor, for families with match.resolve_conditions. Any thread.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace gluray::gl {

/// A shader's text without comments and without the lines that #if, #ifdef, #ifndef, #elif and #else leave
/// out. Definitions that the rest does not use are left out, too. nullopt if a condition asks for more than
/// which names are defined, or for names that the OpenGL defines (GL_..., __VERSION__), or if the text ends
/// within one.
std::optional<std::string> resolveConditions(std::string_view text);

}  // namespace gluray::gl

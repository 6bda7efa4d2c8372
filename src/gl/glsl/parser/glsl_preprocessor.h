// Tokens of a shader after preprocessing: macros expanded, inactive groups left out. Any thread.
#pragma once
#include <string_view>
#include <vector>

namespace gluray::gl {

/// Tokens in the form of GlslTokens, valid as long as `source`. Throws std::runtime_error for text that it
/// does not understand.
std::vector<std::string_view> preprocessed(std::string_view source);

}  // namespace gluray::gl

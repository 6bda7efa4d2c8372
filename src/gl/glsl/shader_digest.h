// Digests of whole shaders: they recognise a text without containing it. Any thread.
#pragma once
#include "base/hash.h"

#include <optional>
#include <string>
#include <string_view>

namespace gluray::gl {

/// The hash of a shader's tokens, with all directives and declarations. Comments, white space and spellings
/// of numbers (GlslTokens) do not count.
Hash128 digestOf(std::string_view shader);

/// A digest as 32 hexadecimal digits.
std::string textOf(const Hash128& digest);
/// The digest that such a text encodes; nullopt if the text is not 32 hexadecimal digits.
std::optional<Hash128> digestIn(std::string_view text);

}  // namespace gluray::gl

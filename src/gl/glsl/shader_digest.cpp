#include "gl/glsl/shader_digest.h"

#include "gl/glsl/glsl_tokens.h"

#include <charconv>
#include <cstdint>
#include <cstdio>

namespace gluray::gl {

Hash128 digestOf(std::string_view shader) {
  std::string tokens;
  GlslTokens read(shader);
  for (std::string_view token = read.nextToken(); !token.empty(); token = read.nextToken())
    tokens.append(token).push_back(' ');
  return hashBytes(tokens.data(), tokens.size());
}

std::string textOf(const Hash128& digest) {
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(digest.high),
                static_cast<unsigned long long>(digest.low));
  return text;
}

std::optional<Hash128> digestIn(std::string_view text) {
  if (text.size() != 32) return std::nullopt;
  Hash128 digest;
  const auto read = [](std::string_view digits, uint64_t& out) {
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, out, 16);
    return error == std::errc() && stop == end;
  };
  if (!read(text.substr(0, 16), digest.high) || !read(text.substr(16), digest.low)) return std::nullopt;
  return digest;
}

}  // namespace gluray::gl

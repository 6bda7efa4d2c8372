// Replaces parts of shader texts.
#pragma once
#include <string>

namespace gluray::test {

/// Replaces each `from` by `to`.
inline std::string replacedInAll(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace gluray::test

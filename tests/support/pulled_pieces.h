// Composes shader texts of pieces. For pulled_vertex_text.cpp and pulled_fragment_text.cpp.
#pragma once
#include <string>

namespace gluray::test {

/// Replaces each `from` by `to`.
inline std::string replacedInAll(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// The text once for each light, with its number for @.
inline std::string forEachLight(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += replacedInAll(text, "@", std::to_string(i));
  return all;
}

}  // namespace gluray::test

// Components of vectors in names of family files: "light.diffuse.r" or "light.diffuse.0" is the first
// component of "light.diffuse".
#pragma once
#include <string_view>

namespace gluray::gl {

/// Index (0 to 3) of the component that the name ends with (.r, .g, .b, .a or .0 to .3); -1: none.
inline int componentIn(std::string_view name) {
  if (name.size() < 3 || name[name.size() - 2] != '.') return -1;
  const size_t at = std::string_view("rgba0123").find(name.back());
  return at == std::string_view::npos ? -1 : static_cast<int>(at % 4);
}

}  // namespace gluray::gl

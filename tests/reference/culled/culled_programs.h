// Shaders of no family, whose draws are culled.
#pragma once
#include <string>

namespace gluray::test::culled {

inline constexpr const char* kCulledVertex = R"(#version 150
in vec3 position;
in vec3 normal;
uniform mat4 clipFromEye, eyeFromObject;
out vec3 place, n;
void main() {
  place = position;
  n = mat3(eyeFromObject) * normal;
  vec4 eye = eyeFromObject * vec4(position, 1.0);
  gl_Position = clipFromEye * eye;
})";
inline constexpr const char* kCulledFragment = R"(#version 150
in vec3 place, n;
out vec4 color;
float wood(vec3 p) { return fract(8.0 * length(p.xz) + 0.4 * sin(9.0 * p.y)); }
void main() {
  vec3 light = vec3(0.1);
  for (int i = 0; i < 3; ++i)
    light += 0.4 * max(dot(normalize(n), normalize(vec3(i - 1, 0.5, 1.0))), 0.0);
  color = vec4(light * mix(vec3(0.5, 0.3, 0.1), vec3(1.0, 0.8, 0.5), wood(place)), 1.0);
})";

inline std::string replacedIn(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

}  // namespace gluray::test::culled

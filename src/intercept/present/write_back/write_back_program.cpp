#include "intercept/present/write_back/write_back_program.h"

#include <algorithm>
#include <cstddef>

namespace gluray::present {
namespace {

constexpr const char* kOldVertex = "#version 110\nvoid main() { gl_Position = gl_Vertex; }\n";

// On llvmpipe (Mesa 22.3), texture2D with nearest filtering takes a third less time than texelFetch.
constexpr const char* kOldFragment = R"(#version 110
uniform sampler2D colorPlane, depthPlane;
uniform vec4 place;
void main() {
  vec2 at = (gl_FragCoord.xy - place.xy) * place.zw;
  float depth = texture2D(depthPlane, at).r;
  if (depth > 1.0) discard;
  gl_FragDepth = depth;
  gl_FragColor = texture2D(colorPlane, at);
}
)";

constexpr const char* kOldSums = R"(#version 110
uniform sampler2D colorPlane, depthPlane;
uniform vec4 place;
void main() {
  vec2 at = (gl_FragCoord.xy - place.xy) * place.zw;
  vec4 sums = texture2D(colorPlane, at);
  gl_FragData[0] = vec4(sums.rgb, 1.0 - texture2D(depthPlane, at).r);
  gl_FragData[1] = vec4(sums.a);
}
)";

// Two triangles per band: x, y of its lower left and upper right corners, in clip space.
constexpr const char* kCoreVertex = R"(
uniform vec4 bands[32];
void main() {
  vec4 band = bands[gl_VertexID / 6];
  int corner = gl_VertexID % 6;
  bool right = corner == 1 || corner == 2 || corner == 4, upper = corner == 2 || corner == 4 || corner == 5;
  gl_Position = vec4(right ? band.z : band.x, upper ? band.w : band.y, 0.0, 1.0);
}
)";

// Without gl_FragColor each draw buffer needs its own output: 8 is the minimum of GL 3.0.
constexpr const char* kCoreFragment = R"(
uniform sampler2D colorPlane, depthPlane;
uniform vec4 place;
out vec4 color[8];
void main() {
  vec2 at = (gl_FragCoord.xy - place.xy) * place.zw;
  float depth = texture(depthPlane, at).r;
  if (depth > 1.0) discard;
  gl_FragDepth = depth;
  vec4 c = texture(colorPlane, at);
  color[0] = c; color[1] = c; color[2] = c; color[3] = c;
  color[4] = c; color[5] = c; color[6] = c; color[7] = c;
}
)";

constexpr const char* kCoreSums = R"(
uniform sampler2D colorPlane, depthPlane;
uniform vec4 place;
out vec4 color[2];
void main() {
  vec2 at = (gl_FragCoord.xy - place.xy) * place.zw;
  vec4 sums = texture(colorPlane, at);
  color[0] = vec4(sums.rgb, 1.0 - texture(depthPlane, at).r);
  color[1] = vec4(sums.a);
}
)";

constexpr const char* kOldTaken = R"(#version 110
uniform sampler2D colorPlane;
uniform vec4 place;
void main() {
  float opacity = texture2D(colorPlane, (gl_FragCoord.xy - place.xy) * place.zw).a;
  if (opacity == 0.0) discard;
  gl_FragColor = vec4(0.0, 0.0, 0.0, opacity);
}
)";

constexpr const char* kCoreTaken = R"(
uniform sampler2D colorPlane;
uniform vec4 place;
out vec4 color[8];
void main() {
  float opacity = texture(colorPlane, (gl_FragCoord.xy - place.xy) * place.zw).r;
  if (opacity == 0.0) discard;
  vec4 c = vec4(0.0, 0.0, 0.0, opacity);
  color[0] = c; color[1] = c; color[2] = c; color[3] = c;
  color[4] = c; color[5] = c; color[6] = c; color[7] = c;
}
)";

/// Fragment shaders by WriteBackSource: for compatibility contexts and, without the version, for core ones.
constexpr const char* kOld[] = {kOldFragment, kOldSums, kOldTaken};
constexpr const char* kCore[] = {kCoreFragment, kCoreSums, kCoreTaken};

std::string firstLine(std::string text) {
  text.resize(std::min(text.find('\0'), text.size()));
  text.resize(std::min(text.find('\n'), text.size()));
  return text;
}

GLuint compileShader(const gl::RealGl& real, GLenum kind, const std::string& source, std::string& why) {
  const GLuint shader = real.CreateShader(kind);
  const char* text = source.c_str();
  real.ShaderSource(shader, 1, &text, nullptr);
  real.CompileShader(shader);
  GLint ok = GL_FALSE;
  real.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  std::string info(1024, '\0');
  real.GetShaderInfoLog(shader, static_cast<GLsizei>(info.size()), nullptr, info.data());
  why = "write-back shader: " + firstLine(info);
  real.DeleteShader(shader);
  return 0;
}

}  // namespace

GLuint buildWriteBackProgram(const gl::RealGl& real, const Features& features, WriteBackSource source,
                             std::string& why) {
  const auto of = static_cast<size_t>(source);
  std::string vertex = kOldVertex, fragment = kOld[of];
  if (!features.compatibility) {
    const std::string version = "#version " + std::to_string(std::min(features.glslVersion, 150)) + "\n";
    vertex = version + kCoreVertex;
    fragment = version + kCore[of];
  }
  const GLuint vertexShader = compileShader(real, GL_VERTEX_SHADER, vertex, why);
  if (!vertexShader) return 0;
  const GLuint fragmentShader = compileShader(real, GL_FRAGMENT_SHADER, fragment, why);
  if (!fragmentShader) return real.DeleteShader(vertexShader), 0;
  const GLuint program = real.CreateProgram();
  real.AttachShader(program, vertexShader);
  real.AttachShader(program, fragmentShader);
  real.LinkProgram(program);
  real.DeleteShader(vertexShader);
  real.DeleteShader(fragmentShader);
  GLint ok = GL_FALSE;
  real.GetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok) return program;
  why = "write-back program does not link";
  real.DeleteProgram(program);
  return 0;
}

}  // namespace gluray::present

#include "intercept/present/raster/depth_redraw.h"

#include "gl/glsl/build_program.h"
#include "gl/real/state_queries.h"
#include "intercept/present/raster/raster_fallback.h"
#include "intercept/present/raster/triangle_array.h"
#include "intercept/present/read_back/sample_copy.h"

#include <functional>
#include <string>
#include <vector>

namespace gluray::present {
namespace {

using gl::RealGl;

/// Vertices are transformed by fixed function, for bit-identical positions. Discards fragments whose depth
/// differs from the existing one by more than tracing and rasterising may differ: they are hidden.
constexpr const char* kSeenAlone = R"(#version 110
uniform sampler2D before;
uniform vec4 place;
void main() {
  float there = texture2D(before, (gl_FragCoord.xy - place.xy) * place.zw).r;
  if (abs(gl_FragCoord.z - there) > 0.00002) discard;
  gl_FragColor = vec4(0.0);
}
)";

/// The same for one sample. `shift`: its position relative to the fragment's depth, which is at the pixel's
/// centre; `slack`: tolerance of that in pixels.
constexpr const char* kSamplesSeenAlone = R"(uniform sampler2DMS before;
uniform vec4 place;
uniform vec2 shift;
uniform float slack;
uniform int sampleAt;
void main() {
  vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
  float depth = gl_FragCoord.z + dot(slope, shift), most = 0.00002 + slack * dot(abs(slope), vec2(1.0));
  float there = texelFetch(before, ivec2(gl_FragCoord.xy - place.xy), sampleAt).r;
  if (abs(depth - there) > most) discard;
  color = vec4(0.0);
}
)";

/// Heads of kSamplesSeenAlone: for vertices of fixed function, and of kByMatrix.
constexpr const char* kFixedHead = "#version 150 compatibility\n#define color gl_FragColor\n";
constexpr const char* kMatrixHead = "#version 150\nout vec4 color;\n";

/// For surfaces that a shader program transforms in the same way: bit-identical, because compilers treat both
/// alike.
constexpr const char* kByMatrix = R"(#version 150
in vec4 vertexMC;
uniform mat4 MCDCMatrix;
void main() { gl_Position = MCDCMatrix * vertexMC; }
)";

constexpr const char* kMatrixSeenAlone = R"(#version 150
uniform sampler2D before;
uniform vec4 place;
out vec4 color;
void main() {
  float there = texelFetch(before, ivec2(gl_FragCoord.xy - place.xy), 0).r;
  if (abs(gl_FragCoord.z - there) > 0.00002) discard;
  color = vec4(0.0);
}
)";

/// `vertex`: null for vertices of fixed function.
GLuint buildSeenAlone(const RealGl& real, const char* vertex, const std::string& fragment) {
  std::vector<gl::ShaderTexts::Shader> shaders{{GL_FRAGMENT_SHADER, fragment}};
  if (vertex) shaders.push_back({GL_VERTEX_SHADER, vertex});
  return gl::buildProgram(real, shaders, [&](GLuint program) {
    if (vertex) real.BindAttribLocation(program, 0, "vertexMC");
  });
}

/// Copies the depth of the region into a new texture; 0 if the real OpenGL refuses.
GLuint copyDepth(const RealGl& real, const Features& features, const scene::Region& region) {
  GLint framebuffer = 0, buffer = 0;
  if (features.readFramebuffers) real.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  real.GetIntegerv(GL_DRAW_BUFFER, &buffer);
  StateGuard guard(real, features);
  guard.plainPack();  // depth without the program's scale and bias
  guard.readFrom(static_cast<GLuint>(framebuffer), static_cast<GLenum>(buffer));
  GLuint name = 0;
  real.GenTextures(1, &name);
  guard.texture2D(0, name);
  for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    real.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  real.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, region.x, region.y, region.width, region.height,
                      0);
  if (takeErrors(real).empty()) return name;
  real.DeleteTextures(1, &name);
  return 0;
}

/// copyDepth() for every sample.
GLuint copyDepthOfSamples(const RealGl& real, const Features& features, const scene::Region& region,
                          GLsizei samples) {
  SampleCopy copy;
  if (copySamples(real, features, region, samples, copy)) return copy.texture;
  real.DeleteTextures(1, &copy.texture);
  return 0;
}

/// Sets the depth pass's uniforms for the copy.
void tell(const RealGl& real, const Features& features, GLuint program, const scene::Region& region) {
  StateGuard guard(real, features);
  guard.program(program);
  real.Uniform4f(real.GetUniformLocation(program, "place"), static_cast<GLfloat>(region.x),
                 static_cast<GLfloat>(region.y), 1.0f / static_cast<GLfloat>(region.width),
                 1.0f / static_cast<GLfloat>(region.height));
}

/// Sets the depth pass's uniforms for one sample.
void tellSample(const RealGl& real, const Features& features, GLuint program, int sample, glm::vec2 shift,
                float slack) {
  StateGuard guard(real, features);
  guard.program(program);
  real.Uniform2f(real.GetUniformLocation(program, "shift"), shift.x, shift.y);
  real.Uniform1f(real.GetUniformLocation(program, "slack"), slack);
  real.Uniform1i(real.GetUniformLocation(program, "sampleAt"), sample);
}

/// Draws the depth of the surfaces with a depth function.
using DrawDepth = std::function<bool(GLenum func, const DepthPass& pass)>;

/// The second draw leaves the nearest of several surfaces that are close to the visible depth.
bool drawTwice(const DrawDepth& draw, const DepthPass& pass) {
  for (const GLenum func : {GL_ALWAYS, GL_LESS})
    if (!draw(func, pass)) return false;
  return true;
}

/// If the program has disabled multisampling, the snapshot has one sample, and all samples of a pixel get the
/// value at its centre: the first represents them. (Mesa 22.3 takes the depth from elsewhere in the pixel.)
bool drawSamples(const RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                 const DrawDepth& draw, DepthPass pass) {
  if (snapshot.samples <= 1) {
    tellSample(real, features, pass.program, 0, {}, 0.5f);
    return drawTwice(draw, pass);
  }
  for (int& i = pass.sample = 0; i < snapshot.samples; ++i) {
    const glm::vec2 shift = snapshot.samplePositions[static_cast<size_t>(i)] - 0.5f;
    tellSample(real, features, pass.program, i, shift, 0);
    if (!drawTwice(draw, pass)) return false;
  }
  return true;
}

/// The function that draws the surfaces, and its program's sources for one sample and for several.
struct Drawer {
  const char* vertex;  // null: fixed function
  const char* single;
  const char* samplesHead;  // precedes kSamplesSeenAlone
  DrawDepth draw;
};

bool drawAgain(const RealGl& real, const Features& features, const scene::Snapshot& snapshot,
               const Drawer& drawer) {
  const GLint samples = gl::integer(real, GL_SAMPLES);
  DepthPass again;
  again.multisampled = samples > 1;
  if (again.multisampled && (features.version < 32 || !features.sampleMask || samples > 32)) return false;
  again.depth = again.multisampled ? copyDepthOfSamples(real, features, snapshot.region, samples)
                                   : copyDepth(real, features, snapshot.region);
  if (!again.depth) return false;
  bool drawn = false;
  again.program = buildSeenAlone(
      real, drawer.vertex,
      again.multisampled ? std::string(drawer.samplesHead) + kSamplesSeenAlone : drawer.single);
  if (again.program) {
    tell(real, features, again.program, snapshot.region);
    drawn = again.multisampled ? drawSamples(real, features, snapshot, drawer.draw, again)
                               : drawTwice(drawer.draw, again);
    real.DeleteProgram(again.program);
  }
  real.DeleteTextures(1, &again.depth);
  return drawn;
}

}  // namespace

bool drawDepthAgain(const RealGl& real, const Features& features, const scene::Snapshot& snapshot) {
  if (!features.compatibility || features.version < 20 || snapshot.region.width <= 0) return false;
  const auto draw = [&](GLenum func, const DepthPass& pass) {
    return drawWithFixedFunction(real, features, snapshot, func, &pass);
  };
  return drawAgain(real, features, snapshot, {nullptr, kSeenAlone, kFixedHead, draw});
}

bool drawDepthAgain(const RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                    const gl::PresentTarget::ByMatrix& surface) {
  if (features.version < 32 || snapshot.region.width <= 0 || snapshot.polygonOffset != scene::PolygonOffset{})
    return false;
  const TriangleArray triangles(real, features, *surface.mesh);
  const auto draw = [&](GLenum func, const DepthPass& pass) {
    triangles.draw(snapshot, surface.clipFromObject, func, pass);
    return true;
  };
  return drawAgain(real, features, snapshot, {kByMatrix, kMatrixSeenAlone, kMatrixHead, draw});
}

}  // namespace gluray::present

// Programs like those of VTK's mappers, their uniforms and arrays, vertex array objects, buffer textures, and
// framebuffer objects that can be traced into.
#include "tests/fuzz/calls.h"
#include "tests/support/program_text.h"

#include <algorithm>

namespace gluray::fuzz {
namespace {

using test::Surface;

Surface surface(Player& p) {
  Surface s;
  s.color = static_cast<Surface::Color>(p.below(4));
  s.normals = static_cast<Surface::Normals>(p.below(3));
  // Programs without lights and physically based ones declare variables without effect, which only a compiler
  // can find out, not NullGl.
  static constexpr Surface::Lights kLights[] = {Surface::Lights::headlight, Surface::Lights::directional,
                                                Surface::Lights::positional};
  s.lights = kLights[p.below(std::size(kLights))];
  s.lightCount = 1 + static_cast<int>(p.below(2));
  s.backMaterial = p.below(8) == 0, s.clipPlanes = p.below(6) == 0;
  s.depthOffset = p.below(6) == 0, s.actorTexture = p.below(6) == 0;
  return s;
}

GLuint& slot(Player& p) { return p.programs[p.below(static_cast<uint32_t>(p.programs.size()))]; }

void attach(Player& p, GLuint program, GLenum kind, const std::string& text) {
  const GLuint shader = p.gl.CreateShader(kind);
  const char* start = text.c_str();
  p.gl.ShaderSource(shader, 1, &start, nullptr);
  p.gl.CompileShader(shader);
  p.gl.AttachShader(program, shader);
  p.gl.DeleteShader(shader);
}

void makeProgram(Player& p) {
  GLuint& place = slot(p);
  const Surface s = surface(p);
  // Commands that are executed while a list is compiled are legal there; these three are not.
  if (p.insideBegin || p.compiling) return;
  p.gl.DeleteProgram(place);
  place = p.gl.CreateProgram();
  attach(p, place, GL_VERTEX_SHADER, vertexText(s));
  attach(p, place, GL_FRAGMENT_SHADER, fragmentText(s));
  p.gl.LinkProgram(place);
}

/// Matrices and materials with a visible result, varied only a little, so that geometry overlaps.
void setAll(Player& p) {
  const GLuint program = slot(p);
  const auto at = [&](const char* name) { return p.gl.GetUniformLocation(program, name); };
  p.gl.UseProgram(program);
  const float scale = 0.5f + 0.5f * static_cast<float>(p.below(4));
  const GLfloat clip[16] = {scale, 0, 0,     0, 0,        scale, 0, 0,
                            0,     0, -0.2f, 0, p.real(), 0,     0, p.below(4) ? 1.0f : 2.0f};
  const GLfloat eye[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -4, 1},
                turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  p.gl.UniformMatrix4fv(at("MCDCMatrix"), 1, GL_FALSE, clip);
  p.gl.UniformMatrix4fv(at("MCVCMatrix"), 1, GL_FALSE, eye);
  p.gl.UniformMatrix3fv(at("normalMatrix"), 1, GL_FALSE, turn);
  const GLfloat white[3] = {1, 1, 1};
  for (const char* name :
       {"ambientColorUniform", "diffuseColorUniform", "specularColorUniform", "lightColor0"})
    p.gl.Uniform3fv(at(name), 1, white);
  for (const char* name : {"ambientIntensity", "diffuseIntensity", "opacityUniform", "specularPowerUniform"})
    p.gl.Uniform1f(at(name), 1);
}

const char* const kUniforms[] = {"MCDCMatrix",
                                 "MCVCMatrix",
                                 "normalMatrix",
                                 "cameraParallel",
                                 "ambientIntensity",
                                 "diffuseIntensity",
                                 "specularIntensity",
                                 "opacityUniform",
                                 "specularPowerUniform",
                                 "diffuseColorUniform",
                                 "specularColorUniform",
                                 "lightColor0",
                                 "lightDirectionVC0",
                                 "lightPositionVC0",
                                 "lightAttenuation0",
                                 "lightConeAngle0",
                                 "lightPositional0",
                                 "PrimitiveIDOffset",
                                 "OverridesColor",
                                 "numClipPlanes",
                                 "clipPlanes",
                                 "clipPlanes[5]",
                                 "cOffset",
                                 "cFactor",
                                 "textureC",
                                 "textureN",
                                 "colortexture",
                                 "actortexture",
                                 "metallicUniform",
                                 "roughnessUniform"};

void uniform(Player& p) {
  const GLuint program = slot(p);
  const char* name = kUniforms[p.below(std::size(kUniforms))];
  const uint32_t kind = p.below(6);
  std::array<float, 16> values;
  for (float& v : values) v = p.real();
  const GLint whole = p.integer();
  p.gl.UseProgram(program);
  const GLint at = p.gl.GetUniformLocation(program, name);
  switch (kind) {
    case 0: return p.gl.Uniform1f(at, values[0]);
    case 1: return p.gl.Uniform1i(at, whole);
    case 2: return p.gl.Uniform3fv(at, 1, values.data());
    case 3: return p.gl.Uniform4fv(at, 1, values.data());
    case 4: return p.gl.UniformMatrix4fv(at, 1, GL_FALSE, values.data());
    default: return p.gl.UniformMatrix3fv(at, 1, GL_FALSE, values.data());
  }
}

/// One of the program's arrays, from a buffer that is usually large enough.
void array(Player& p) {
  static constexpr const char* kNames[] = {"vertexMC", "vertexMC",    "vertexMC",
                                           "normalMC", "scalarColor", "tcoord"};
  const GLuint program = slot(p);
  const char* name = kNames[p.below(std::size(kNames))];
  const GLuint buffer = 1 + p.below(kVertexBuffers);
  const GLsizei stride = static_cast<GLsizei>(4 * p.below(8));
  const uintptr_t offset = 4 * p.below(32);
  const bool bytes = p.below(6) == 0;
  const GLuint divisor = p.below(12) == 0 ? 1 : 0;
  if (p.insideBegin) return;
  const GLint at = p.gl.GetAttribLocation(program, name);
  if (at < 0) return;
  p.gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  const auto index = static_cast<GLuint>(at);
  p.gl.VertexAttribPointer(index, bytes ? 4 : 3, bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, bytes, stride,
                           reinterpret_cast<const void*>(offset));
  p.gl.VertexAttribDivisor(index, divisor);
  p.gl.EnableVertexAttribArray(index);
}

/// Framebuffer 1 or 2 with colour and depth, so that draws into it can be traced.
void framebuffer(Player& p) {
  const GLuint name = 1 + p.below(2);
  p.gl.Finish();
  p.gl.BindTexture(GL_TEXTURE_2D, 10 + name);
  p.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, p.read());
  p.gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  p.gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kSize, kSize);
  p.gl.BindFramebuffer(GL_FRAMEBUFFER, name);
  p.gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 10 + name, 0);
  p.gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, name);
}

void texBuffer(Player& p) {
  const GLenum unit = GL_TEXTURE0 + p.below(3);
  const GLuint buffer = 1 + p.below(kVertexBuffers);
  const GLenum format = p.pick({GL_RGBA8, GL_RGBA32F, GL_R32F, GL_RGB32F, GL_R8});
  p.gl.ActiveTexture(unit);
  p.gl.BindTexture(GL_TEXTURE_BUFFER, 60 + unit - GL_TEXTURE0);
  p.gl.TexBuffer(GL_TEXTURE_BUFFER, format, buffer);
  p.gl.ActiveTexture(GL_TEXTURE0);
}

GLuint vertexArray(Player& p) { return p.vertexArrays[p.context][p.below(3)]; }

const Op kProgramOps[] = {
    {"make program", 4, makeProgram},
    {"set all", 8, setAll},
    {"Uniform", 16, uniform},
    {"program array", 16, array},
    {"UseProgram", 6, [](Player& p) { p.gl.UseProgram(slot(p)); }},
    {"UseProgram 0", 3, [](Player& p) { p.gl.UseProgram(0); }},
    {"LinkProgram", 2, [](Player& p) { p.gl.LinkProgram(slot(p)); }},
    {"BindAttribLocation", 1, [](Player& p) { p.gl.BindAttribLocation(slot(p), 3, "vertexMC"); }},
    {"DeleteProgram", 1, [](Player& p) { p.gl.DeleteProgram(slot(p)); }},
    {"BindVertexArray", 6, [](Player& p) { p.gl.BindVertexArray(vertexArray(p)); }},
    {"BindVertexArray 0", 3, [](Player& p) { p.gl.BindVertexArray(0); }},
    {"DeleteVertexArrays", 1,
     [](Player& p) {
       const GLuint name = vertexArray(p);
       p.gl.DeleteVertexArrays(1, &name);
     }},
    {"DrawArraysInstanced", 4,
     [](Player& p) {
       const GLint first = static_cast<GLint>(p.below(20));
       const GLsizei count = p.count(60);
       p.gl.DrawArraysInstanced(GL_TRIANGLES, first, count, p.count(3));
     }},
    {"framebuffer", 2, framebuffer},
    {"TexBuffer", 4, texBuffer},
};

/// Resets the state of the stream so that surfaces are traced.
void calm(Player& p) {
  const bool program = p.below(3) == 0;
  const GLuint name = slot(p);
  if (p.insideBegin || p.compiling) return;
  p.gl.EndQuery(GL_SAMPLES_PASSED), p.gl.RenderMode(GL_RENDER);
  p.gl.BindFramebuffer(GL_FRAMEBUFFER, 0), p.gl.DrawBuffer(GL_FRONT);
  p.gl.UseProgram(program ? name : 0), p.gl.BindVertexArray(0);
  for (GLuint i = 0; i < 16 && !program; ++i) p.gl.DisableVertexAttribArray(i);
  p.gl.DisableClientState(GL_EDGE_FLAG_ARRAY);
  for (const GLenum capability :
       {GL_BLEND, GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_ALPHA_TEST, GL_POLYGON_STIPPLE, GL_POLYGON_SMOOTH,
        GL_POLYGON_OFFSET_FILL, GL_PRIMITIVE_RESTART, GL_SCISSOR_TEST, GL_TEXTURE_2D, GL_TEXTURE_1D,
        GL_TEXTURE_3D})
    p.gl.Disable(capability);
  for (GLenum plane = GL_CLIP_PLANE0; plane < GL_CLIP_PLANE0 + 6; ++plane) p.gl.Disable(plane);
  p.gl.Enable(GL_DEPTH_TEST), p.gl.DepthFunc(GL_LESS), p.gl.DepthMask(GL_TRUE);
  p.gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE), p.gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  p.gl.Viewport(0, 0, kSize, kSize);
  for (const GLenum mode : {GL_PROJECTION, GL_MODELVIEW}) p.gl.MatrixMode(mode), p.gl.LoadIdentity();
  p.gl.Rotatef(90 * p.real(), 1, 0.5f, 0);
  p.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}
const Op kCalmOps[] = {{"calm", 1, calm}};

}  // namespace

Ops calmCalls() { return kCalmOps; }
Ops programCalls() { return kProgramOps; }

}  // namespace gluray::fuzz

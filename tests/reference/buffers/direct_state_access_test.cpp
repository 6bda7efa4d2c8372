// Scenes drawn only with direct state access (OpenGL 4.5): objects are made, filled and attached
// by name, in a core context with a shader program and in a compatibility context with fixed function.
#include "tests/reference/hostile/habits.h"
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

template <class T>
GLuint bufferOf(Gl gl, const std::vector<T>& values) {
  GLuint name = 0;
  gl.CreateBuffers(1, &name);
  const auto bytes = static_cast<GLsizeiptr>(values.size() * sizeof(T));
  gl.NamedBufferData(name, bytes, nullptr, GL_STATIC_DRAW);
  gl.NamedBufferSubData(name, 0, bytes, values.data());
  return name;
}

/// Colour and depth of its own, cleared.
GLuint framebuffer(Gl gl, int width, int height) {
  GLuint name = 0, color = 0, depth = 0;
  gl.CreateTextures(GL_TEXTURE_2D, 1, &color), gl.TextureStorage2D(color, 1, GL_RGBA8, width, height);
  gl.CreateRenderbuffers(1, &depth);
  gl.NamedRenderbufferStorage(depth, GL_DEPTH_COMPONENT24, width, height);
  gl.CreateFramebuffers(1, &name);
  gl.NamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, color, 0);
  gl.NamedFramebufferRenderbuffer(name, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  gl.NamedFramebufferDrawBuffer(name, GL_COLOR_ATTACHMENT0);
  gl.NamedFramebufferReadBuffer(name, GL_COLOR_ATTACHMENT0);
  EXPECT_EQ(gl.CheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER),
            static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  const float sky[4] = {0.1f, 0.2f, 0.3f, 1}, far = 1;
  gl.ClearNamedFramebufferfv(name, GL_COLOR, 0, sky), gl.ClearNamedFramebufferfv(name, GL_DEPTH, 0, &far);
  return name;
}

void show(Gl gl, GLuint from, int width, int height) {
  gl.BlitNamedFramebuffer(from, 0, 0, 0, width, height, 0, 0, width, height,
                          GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

/// A vertex array with the mesh at the attributes that `program` has.
GLuint arrayOf(Gl gl, const ProgramMesh& mesh, GLuint program) {
  GLuint array = 0;
  gl.CreateVertexArrays(1, &array);
  GLuint binding = 0;
  const auto add = [&](const char* name, GLuint buffer, GLint size, GLsizei stride) {
    const GLint place = gl.GetAttribLocation(program, name);
    if (place < 0) return;
    const auto at = static_cast<GLuint>(place);
    gl.VertexArrayVertexBuffer(array, binding, buffer, 0, stride);
    gl.VertexArrayAttribFormat(array, at, size, GL_FLOAT, GL_FALSE, 0);
    gl.VertexArrayAttribBinding(array, at, binding++);
    gl.EnableVertexArrayAttrib(array, at);
  };
  add("vertexMC", bufferOf(gl, mesh.positions), 3, 12);
  add("normalMC", bufferOf(gl, mesh.normals), 3, 12);
  add("tcoord", bufferOf(gl, mesh.texcoords), 2, 8);
  gl.VertexArrayElementBuffer(array, bufferOf(gl, mesh.indices));
  return array;
}

/// Sets what setAll() sets, but the program is not in use.
void setByName(Gl gl, GLuint program, const View& view) {
  const auto at = [&](const char* name) { return gl.GetUniformLocation(program, name); };
  const glm::mat4 clip(view.clipFromEye * view.eyeFromObject), eye(view.eyeFromObject);
  const glm::mat3 normal(glm::transpose(glm::inverse(glm::dmat3(view.eyeFromObject))));
  gl.ProgramUniformMatrix4fv(program, at("MCDCMatrix"), 1, GL_FALSE, glm::value_ptr(clip));
  gl.ProgramUniformMatrix4fv(program, at("MCVCMatrix"), 1, GL_FALSE, glm::value_ptr(eye));
  gl.ProgramUniformMatrix3fv(program, at("normalMatrix"), 1, GL_FALSE, glm::value_ptr(normal));
  for (const char* name : {"ambientIntensity", "diffuseIntensity", "specularIntensity", "opacityUniform"})
    gl.ProgramUniform1f(program, at(name), 1);
  gl.ProgramUniform1f(program, at("specularPowerUniform"), 20);
  const glm::vec3 light(0.9f, 0.8f, 0.7f), dim(0.1f);
  gl.ProgramUniform3fv(program, at("lightColor0"), 1, glm::value_ptr(light));
  gl.ProgramUniform3fv(program, at("diffuseColorUniform"), 1, glm::value_ptr(light));
  gl.ProgramUniform3fv(program, at("ambientColorUniform"), 1, glm::value_ptr(dim));
  gl.ProgramUniform3fv(program, at("specularColorUniform"), 1, glm::value_ptr(dim));
}

TEST(DirectStateAccess, AProgramsSceneInACoreContext) {
  expectBoth(
      "direct_state_access",
      [](Gl gl) {
        const GLuint target = framebuffer(gl, kProgramWidth, kProgramHeight);
        gl.BindFramebuffer(GL_FRAMEBUFFER, target);
        gl.Viewport(0, 0, kProgramWidth, kProgramHeight);
        gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(GL_LEQUAL);
        const Surface surface{.lights = Surface::Lights::headlight, .actorTexture = true};
        const GLuint program = makeProgram(gl, surface);
        const ProgramMesh mesh = ball(20);
        gl.BindVertexArray(arrayOf(gl, mesh, program));
        GLuint texture = 0;
        gl.CreateTextures(GL_TEXTURE_2D, 1, &texture);
        gl.TextureStorage2D(texture, 1, GL_RGBA8, 4, 4);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
          gl.TextureParameteri(texture, filter, GL_NEAREST);
        gl.BindTextureUnit(3, texture);
        gl.ProgramUniform1i(program, gl.GetUniformLocation(program, "actortexture"), 3);
        gl.UseProgram(program);
        for (const double x : {-0.7, 0.7}) {  // the texture's image and the uniforms change in between
          std::vector<uint32_t> texels(16, x < 0 ? 0xff3060f0u : 0xffc0f020u);
          texels[5] = texels[10] = 0xffffffffu;
          gl.TextureSubImage2D(texture, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
          View view = perspectiveView(30 + 20 * x);
          view.eyeFromObject[3][0] += x;
          setByName(gl, program, view);
          gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
        }
        show(gl, target, kProgramWidth, kProgramHeight);
      },
      2, coreWish(4, 5));
}

TEST(DirectStateAccess, AFixedFunctionSceneInACompatibilityContext) {
  using namespace twenty_points;
  const auto draw = [](Gl gl, Seen&) {
    stage(gl);
    const GLuint target = framebuffer(gl, kWidth, kHeight);
    gl.BindFramebuffer(GL_FRAMEBUFFER, target);
    const Model m = sphere(24, 36);
    gl.BindBuffer(GL_ARRAY_BUFFER, bufferOf(gl, m.positions));
    gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.BindBuffer(GL_ARRAY_BUFFER, bufferOf(gl, m.normals));
    gl.NormalPointer(GL_FLOAT, 0, nullptr), gl.EnableClientState(GL_NORMAL_ARRAY);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, bufferOf(gl, m.indices));
    for (const float x : {-0.6f, 0.6f}) {
      gl.PushMatrix(), gl.Translatef(x, 0, 0), gl.Scalef(0.6f, 0.6f, 0.6f);
      gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(m.indices.size()), GL_UNSIGNED_INT, nullptr);
      gl.PopMatrix();
    }
    show(gl, target, kWidth, kHeight);
  };
  twenty_points::expectSame(draw, {.traced = 2});
}

}  // namespace
}  // namespace gluray::test

// A multisampled framebuffer and a plain one, and every way to resolve the one into the other, for
// resolve_test.cpp.
#pragma once
#include "settings/quirks.h"
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace gluray::test::resolve {

inline constexpr int kWidth = kProgramWidth, kHeight = kProgramHeight, kSamples = 4;
inline constexpr GLbitfield kColor = GL_COLOR_BUFFER_BIT, kDepth = GL_DEPTH_BUFFER_BIT;

/// Samples lie where the real OpenGL has them; each is shaded at its own place, not at the pixel's centre.
inline constexpr scenes::Tolerance kResolveTolerance = {3, 0.004, 1e-5f,
                                                        "silhouettes; lighting at samples, not at centres"};

/// VTK's pass that averages samples (vtkOpenGLRenderWindow of 9.1; newer ones call `sample` sampleValue), of
/// `only` one of them where that is not negative.
inline std::string resolveText(int only = -1, const std::string& sample = "sample") {
  const std::string first = only < 0 ? "0" : std::to_string(only),
                    end = only < 0 ? "samplecount" : std::to_string(only + 1);
  return "#version 150\nin vec2 texCoord;\nuniform sampler2DMS tex;\nuniform int samplecount;\n"
         "out vec4 fragOutput0;\nvoid main() {\n  float gamma = 2.2;\n"
         "  ivec2 itexcoords = ivec2(floor(textureSize(tex) * texCoord));\n"
         "  vec3 accumulate = vec3(0.0,0.0,0.0);\n  float alpha = 0.0;\n  for (int i = " +
         first + "; i < " + end +
         "; i++) {\n"
         "    vec4 " +
         sample + " = texelFetch(tex, itexcoords, i);\n    accumulate += pow(" + sample +
         ".rgb, vec3(gamma));\n    alpha += " + sample +
         ".a;\n  }\n"
         "  accumulate /= float(samplecount);\n"
         "  fragOutput0 = vec4(pow(accumulate, vec3(1.0/gamma)), alpha/float(samplecount));\n}\n";
}

inline const std::string kPassVertex =
    "#version 150\nin vec4 ndCoordIn;\nin vec2 texCoordIn;\nout vec2 texCoord;\n"
    "void main() { gl_Position = ndCoordIn; texCoord = texCoordIn; }\n";

/// A strip of four corners: place and texture coordinates.
inline const std::vector<GLfloat> kPassData = {-1, -1, 0, 0, 1, -1, 1, 0, -1, 1, 0, 1, 1, 1, 1, 1};

/// A multisampled framebuffer object and a plain one, and something to draw.
struct Stage {
  Gl gl;
  GLuint many = 0, plain = 0, samples = 0, sampleDepths = 0;
  GLuint program = 0;
  ProgramMesh mesh = ball(24);
  Upload up;
  Surface surface;

  explicit Stage(Gl table, bool textures = true) : gl(table) {
    many = framebuffer(), attachSamples(textures);
    plain = framebuffer(), attachPixels(textures);
    program = makeProgram(gl, surface);
    up = upload(gl, mesh, program);
  }
  GLuint framebuffer() const {
    GLuint name = 0;
    gl.GenFramebuffers(1, &name);
    gl.BindFramebuffer(GL_FRAMEBUFFER, name);
    return name;
  }
  void attachSamples(bool textures) {
    for (const bool depth : {false, true}) {
      const GLenum format = depth ? GL_DEPTH_COMPONENT32 : GL_RGBA8;
      const GLenum place = depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
      GLuint& name = depth ? sampleDepths : samples;
      if (textures) {
        gl.GenTextures(1, &name);
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
        gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, kSamples, format, kWidth, kHeight, GL_TRUE);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D_MULTISAMPLE, name, 0);
      } else {
        gl.GenRenderbuffers(1, &name);
        gl.BindRenderbuffer(GL_RENDERBUFFER, name);
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, format, kWidth, kHeight);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, name);
      }
    }
    EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  }
  void attachPixels(bool textures) const {
    for (const bool depth : {false, true}) {
      const GLenum place = depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
      const auto format = static_cast<GLenum>(depth ? GL_DEPTH_COMPONENT32 : GL_RGBA8);
      GLuint name = 0;
      if (textures) {
        gl.GenTextures(1, &name);
        gl.BindTexture(GL_TEXTURE_2D, name);
        gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), kWidth, kHeight, 0,
                      depth ? GL_DEPTH_COMPONENT : GL_RGBA, depth ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, name, 0);
      } else {
        gl.GenRenderbuffers(1, &name);
        gl.BindRenderbuffer(GL_RENDERBUFFER, name);
        gl.RenderbufferStorage(GL_RENDERBUFFER, format, kWidth, kHeight);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, name);
      }
    }
    EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  }

  void open() const { gl.BindFramebuffer(GL_FRAMEBUFFER, many); }
  void drawBall(double degrees = 0) const {
    drawSurface(gl, program, up, mesh, perspectiveView(degrees), surface);
  }
  /// Clears, draws, and binds another framebuffer.
  void frame(double degrees = 0) const {
    open();
    beginFrame(gl);
    drawBall(degrees);
    close();
  }
  void close() const {
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, plain);
  }
  void blit(GLbitfield mask = kColor | kDepth, GLuint to = 0) const {
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, many);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to ? to : plain);
    gl.BlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, mask, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, plain);
  }
  /// Resolves colours by a full-screen pass; `only`: takes that sample instead of the average.
  void resolve(bool only = false) const {
    const GLuint pass = only ? second.program : average.program;
    gl.BindFramebuffer(GL_FRAMEBUFFER, plain);
    gl.UseProgram(pass);
    gl.Disable(GL_DEPTH_TEST), gl.Disable(GL_BLEND);
    gl.ActiveTexture(GL_TEXTURE3);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, samples);
    setInteger(gl, pass, "tex", 3);
    setInteger(gl, pass, "samplecount", only ? 1 : kSamples);
    gl.BindVertexArray(only ? second.array : average.array);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindVertexArray(0);
  }
  /// From now on uses a program with a different text for averaging.
  void averageBy(const std::string& fragment) {
    average = simple(kPassVertex, fragment, kPassData, {"ndCoordIn", "texCoordIn"}, 2);
  }
  /// Lets the real OpenGL draw a line across the image in the bound framebuffer.
  void line() const {
    gl.UseProgram(flat.program);
    gl.BindVertexArray(flat.array);
    gl.DrawArrays(GL_LINES, 0, 2);
    gl.BindVertexArray(0);
  }

 private:
  struct Simple {
    GLuint program = 0, array = 0;
  };
  /// Vertices of attributes of `size` floats each.
  Simple simple(const std::string& vertex, const std::string& fragment, std::vector<GLfloat> data,
                std::initializer_list<const char*> names, GLint size) const {
    Simple result{makeProgram(gl, vertex, fragment)};
    GLuint buffer = 0;
    gl.GenVertexArrays(1, &result.array), gl.GenBuffers(1, &buffer);
    gl.BindVertexArray(result.array);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof data[0]), data.data(),
                  GL_STATIC_DRAW);
    size_t offset = 0;
    const size_t bytes = static_cast<size_t>(size) * sizeof(GLfloat);
    for (const char* name : names) {
      const auto place = static_cast<GLuint>(gl.GetAttribLocation(result.program, name));
      gl.EnableVertexAttribArray(place);
      gl.VertexAttribPointer(place, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(bytes * names.size()),
                             reinterpret_cast<const void*>(offset));
      offset += bytes;
    }
    gl.BindVertexArray(0);
    return result;
  }
  Simple pass(int only) const {
    return simple(kPassVertex, resolveText(only), kPassData, {"ndCoordIn", "texCoordIn"}, 2);
  }
  Simple average = pass(-1), second = pass(2);
  Simple flat = simple("#version 150\nin vec4 at;\nvoid main() { gl_Position = at; }\n",
                       "#version 150\nout vec4 c;\nvoid main() { c = vec4(1, 0, 0, 1); }\n",
                       {-0.9f, -0.8f, -0.99f, 0.7f, 0.9f, -0.99f}, {"at"}, 3);
};

/// Expects equal images from `plain` and `ours`, `traced` traced draws, `resolves` resolves by GLuRay.
inline void expectResolves(const std::string& name, uint64_t resolves, int traced,
                           const std::function<void(Stage&)>& draw, bool textures = true,
                           const scenes::Tolerance& tolerance = kResolveTolerance) {
  const auto all = [&](Gl gl) {
    Stage stage(gl, textures);
    draw(stage);
    gl.BindFramebuffer(GL_FRAMEBUFFER, stage.plain);
  };
  const uint64_t before = useCount(Quirk::softwareResolve);
  const Outcome outcome = expectSame("resolve_" + name, all, traced, {}, tolerance);
  EXPECT_EQ(useCount(Quirk::softwareResolve) - before, resolves) << name;
  EXPECT_GT(
      std::count_if(outcome.got.depths.begin(), outcome.got.depths.end(), [](float d) { return d < 1; }),
      resolves ? 3000 : -1)
      << name;
  expectSameWhenTracingFails("resolve_" + name, all);
}

}  // namespace gluray::test::resolve

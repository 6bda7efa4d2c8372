// Multisampled framebuffers that are cleared, traced into and resolved: the pixels are made without them
// (quirk software-resolve); whatever else looks at the samples finds them.
#include "settings/quirks.h"
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gluray::test {
namespace {

constexpr int kWidth = kProgramWidth, kHeight = kProgramHeight, kSamples = 4;
constexpr GLbitfield kColor = GL_COLOR_BUFFER_BIT, kDepth = GL_DEPTH_BUFFER_BIT;

/// Samples lie where the real OpenGL has them; their colours are of their own places, not of the pixel's.
constexpr scenes::Tolerance kResolveTolerance = {3, 0.004, 1e-5f,
                                                 "silhouettes; lighting at samples, not at centres"};

/// VTK's pass that averages samples (vtkOpenGLRenderWindow of 9.1; newer ones call `sample` sampleValue), of
/// `only` one of them where that is not negative.
std::string resolveText(int only = -1, const std::string& sample = "sample") {
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

const std::string kPassVertex =
    "#version 150\nin vec4 ndCoordIn;\nin vec2 texCoordIn;\nout vec2 texCoord;\n"
    "void main() { gl_Position = ndCoordIn; texCoord = texCoordIn; }\n";

/// A strip of four corners: place and texture coordinates.
const std::vector<GLfloat> kPassData = {-1, -1, 0, 0, 1, -1, 1, 0, -1, 1, 0, 1, 1, 1, 1, 1};

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
  /// Clears and draws, and turns away.
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
  /// By a full-screen pass, colours alone; `only`: of that sample.
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
  /// From now on by a program that averages in other words.
  void averageBy(const std::string& fragment) {
    average = simple(kPassVertex, fragment, kPassData, {"ndCoordIn", "texCoordIn"}, 2);
  }
  /// A line of the real OpenGL's across the picture, in what is bound.
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

/// The real OpenGL's picture of `plain`, `ours` of `traced` draws, where `resolves` were made without it.
void expectResolves(const std::string& name, uint64_t resolves, int traced,
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

TEST(Resolve, ByBlitsOfColorsAndDepths) {
  expectResolves("blit", 1, 1, [](const Stage& s) { s.frame(), s.blit(); });
  expectResolves("blits", 2, 1, [](const Stage& s) { s.frame(), s.blit(kColor), s.blit(kDepth); });
  expectResolves(
      "renderbuffers", 1, 1, [](const Stage& s) { s.frame(), s.blit(); }, false);
}

TEST(Resolve, ByVtksPass) {
  expectResolves("pass", 2, 1, [](const Stage& s) { s.frame(), s.resolve(), s.blit(kDepth); });
}

TEST(Resolve, ByNewerWordsOfVtks) {
  expectResolves("newer", 2, 1, [](Stage& s) {
    s.averageBy(resolveText(-1, "sampleValue"));
    s.frame(), s.resolve(), s.blit(kDepth);
  });
}

TEST(Resolve, WhatComputesSomethingElseIsNotVtks) {
  expectResolves("darker", 0, 1, [](Stage& s) {
    std::string text = resolveText();
    text.insert(text.find("  fragOutput0"), "  accumulate *= 0.5;\n");
    s.averageBy(text);
    s.frame(), s.resolve();
  });
}

TEST(Resolve, FrameAfterFrame) {
  expectResolves("frames", 6, 3, [](const Stage& s) {
    for (int i = 0; i < 3; ++i) s.frame(20 * i), s.resolve(), s.blit(kDepth);
  });
}

TEST(Resolve, IntoTwoFramebuffers) {
  expectResolves("two", 2, 1, [](const Stage& s) {
    const GLuint other = s.framebuffer();
    s.attachPixels(true);
    s.frame();
    s.blit(kColor, other);
    s.blit();
  });
}

TEST(Resolve, DepthFunctionsAndWhatTheyMeet) {
  expectResolves("less", 1, 1, [](const Stage& s) {
    s.open();
    beginFrame(s.gl);
    s.gl.DepthFunc(GL_LESS);
    s.drawBall();
    s.close(), s.blit();
  });
  expectResolves("nearer", 0, 1, [](const Stage& s) {
    s.open();
    s.gl.ClearDepth(0.9f);
    beginFrame(s.gl);
    s.gl.ClearDepth(1);
    s.drawBall();
    s.close(), s.blit();
  });
}

TEST(Resolve, WhatIsRasterisedInBetweenIsThere) {
  expectResolves("line_before", 0, 1, [](const Stage& s) {
    s.open(), beginFrame(s.gl), s.line(), s.drawBall(), s.close(), s.blit();
  });
  expectResolves("line_after", 0, 1, [](const Stage& s) {
    s.open(), beginFrame(s.gl), s.drawBall(), s.line(), s.close(), s.blit();
  });
  expectResolves("line_later", 0, 1, [](const Stage& s) { s.frame(), s.open(), s.line(), s.blit(); });
  expectResolves("line_elsewhere", 1, 1, [](const Stage& s) {
    s.frame();
    s.gl.BindFramebuffer(GL_FRAMEBUFFER, 0), s.line();
    s.blit();
  });
}

TEST(Resolve, WhatIsTracedLaterIsThere) {
  expectResolves("more", 0, 2, [](const Stage& s) { s.frame(), s.open(), s.drawBall(70), s.blit(); });
}

TEST(Resolve, ClearsOfPartsHideNothingElse) {
  expectResolves("depth_cleared", 0, 2, [](const Stage& s) {
    s.frame(), s.open(), s.gl.Clear(kDepth), s.drawBall(70), s.close(), s.blit();
  });
  expectResolves("part_cleared", 0, 1, [](const Stage& s) {
    s.frame(), s.open();
    s.gl.Enable(GL_SCISSOR_TEST), s.gl.Scissor(0, 0, kWidth / 2, kHeight);
    s.gl.Clear(kColor | kDepth);
    s.gl.Disable(GL_SCISSOR_TEST);
    s.close(), s.blit();
  });
  expectResolves("red_cleared", 0, 1, [](const Stage& s) {
    s.frame(), s.open();
    s.gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
    s.gl.Clear(kColor | kDepth);
    s.gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    s.close(), s.blit();
  });
  expectResolves("begun_in_part", 1, 2, [](const Stage& s) {
    s.frame(), s.blit(kColor), s.open();
    s.gl.Enable(GL_SCISSOR_TEST), s.gl.Scissor(0, 0, kWidth / 2, kHeight);
    beginFrame(s.gl);
    s.gl.Disable(GL_SCISSOR_TEST);
    s.drawBall(70), s.close(), s.blit();
  });
}

TEST(Resolve, WhoReadsSingleSamplesFindsThem) {
  // Nothing is averaged: where a triangle is seen from its edge, a sample is lit otherwise than the centre.
  constexpr scenes::Tolerance kSample = {16, 0.001, 1e-5f, "lighting at samples, not at centres"};
  expectResolves(
      "sample", 0, 1, [](const Stage& s) { s.frame(), s.resolve(true); }, true, kSample);
  expectResolves(
      "sample_later", 1, 1, [](const Stage& s) { s.frame(), s.blit(), s.resolve(true); }, true, kSample);
}

TEST(Resolve, BlitsOfParts) {
  expectResolves("part", 1, 1, [](const Stage& s) {
    s.frame();
    s.blit();
    s.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, s.many);
    s.gl.BlitFramebuffer(10, 10, 90, 90, 20, 20, 100, 100, kColor, GL_NEAREST);
  });
  expectResolves("scissor", 0, 1, [](const Stage& s) {
    s.gl.BindFramebuffer(GL_FRAMEBUFFER, s.plain), beginFrame(s.gl);
    s.frame();
    s.gl.Enable(GL_SCISSOR_TEST), s.gl.Scissor(0, 0, kWidth / 2, kHeight);
    s.blit();
    s.gl.Disable(GL_SCISSOR_TEST);
  });
}

TEST(Resolve, AnotherFramebufferOfTheSameSamples) {
  const auto alias = [](const Stage& s) {
    const GLuint name = s.framebuffer();
    s.gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, s.samples, 0);
    s.gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE, s.sampleDepths,
                              0);
    return name;
  };
  expectResolves("alias_read", 0, 1, [&](const Stage& s) {
    const GLuint name = alias(s);
    s.frame();
    s.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, name), s.gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, s.plain);
    s.gl.BlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, kColor | kDepth, GL_NEAREST);
  });
  expectResolves("alias_drawn", 0, 1, [&](const Stage& s) {
    const GLuint name = alias(s);
    s.frame();
    s.gl.BindFramebuffer(GL_FRAMEBUFFER, name), s.line();
    s.blit();
  });
}

TEST(Resolve, AttachmentsThatChangeMeanwhile) {
  expectResolves("detached", 0, 1, [](const Stage& s) {
    s.frame(), s.open();
    s.gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, 0, 0);
    s.gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, s.samples, 0);
    s.close(), s.blit();
  });
  expectResolves("deleted", 0, 1, [](const Stage& s) {
    s.frame();
    s.gl.DeleteTextures(1, &s.samples);  // lives on in the framebuffer object
    s.blit();
  });
}

TEST(Resolve, QueriesCountNothingOfIt) {
  expectResolves("query", 0, 1, [](const Stage& s) {
    s.frame();
    GLuint query = 0, passed = 7;
    s.gl.GenQueries(1, &query);
    s.gl.BeginQuery(GL_SAMPLES_PASSED, query);
    s.blit();
    s.gl.EndQuery(GL_SAMPLES_PASSED);
    s.gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
    EXPECT_EQ(passed, 0u);
  });
}

/// With and without the quirk.
Comparison switched(const std::function<void(const Stage&)>& draw, int channel) {
  const auto picture = [&](bool on) {
    Settings settings = TracedContext::tracing();
    EXPECT_TRUE(settings.quirks.set("software-resolve", on));
    const uint64_t before = useCount(Quirk::softwareResolve);
    const TracedContext context(coreWish(), settings);
    const Stage stage(context.gl());
    draw(stage);
    Picture result = readPicture(context.gl(), kWidth, kHeight);
    EXPECT_EQ(useCount(Quirk::softwareResolve) - before, on ? 2u : 0u);
    return result;
  };
  return compare(picture(false), picture(true), {channel, 0, 0, "the real OpenGL's powers are rounded"});
}

TEST(Resolve, SwitchedOffItIsTheSamePicture) {
  const Comparison pass = switched([](const Stage& s) { s.frame(), s.resolve(), s.blit(kDepth); }, 1);
  EXPECT_TRUE(pass.accepted) << pass.text;
  EXPECT_EQ(pass.depthMax, 0) << pass.text;
  const Comparison blit = switched([](const Stage& s) { s.frame(), s.blit(kColor), s.blit(kDepth); }, 0);
  EXPECT_TRUE(blit.accepted) << blit.text;
  EXPECT_EQ(blit.depthMax, 0) << blit.text;
}

}  // namespace
}  // namespace gluray::test

// Culled draws beside state that few programs use: it rules them out, or stays as the program has set it.
#include "gl/real/extensions.h"
#include "tests/reference/culled/culled_programs.h"
#include "tests/reference/culled/sampled_framebuffer.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace gluray::test::rare_culled_state {
namespace {

using namespace culled;

constexpr ContextWish kNewest{kSide, kSide, true, 4, 5};

/// Draws the mesh in `frames` with a program that `make` makes.
struct Drawn {
  std::function<GLuint(Gl)> make = [](Gl gl) { return makeProgram(gl, kCulledVertex, kCulledFragment); };
  std::function<void(Gl, GLuint program)> prepare = [](Gl, GLuint) {};
  std::function<void(Gl, GLuint program)> state = [](Gl, GLuint) {};  // after it is in use
  int samples = 1, draws = 1;
  ContextWish wish{kSide, kSide, true, 3, 2};
};

gl::Statistics compareDrawn(const std::string& name, const Drawn& of) {
  GLuint program = 0, array = 0;
  const ProgramMesh mesh = shells(5, 100);
  return compareSamples(
      "rare_" + name, 4, of.samples, GL_DEPTH24_STENCIL8,
      [&](Gl gl) {
        program = of.make(gl);
        array = send(gl, mesh, program).array;
        of.prepare(gl, program);
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program), gl.BindVertexArray(array);
        of.state(gl, program);
        for (int i = 0; i < of.draws; ++i) {
          turn(gl, program, frame + 3 * i);
          gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
        }
      },
      nullptr, of.wish);
}

/// Fragments get their alpha from an attribute, which `alpha` gives at all vertices.
Drawn tinted(float alpha) {
  Drawn drawn;
  drawn.make = [](Gl gl) {
    const std::string vertex = replacedIn(
        replacedIn(kCulledVertex, "in vec3 normal;", "in vec3 normal;\nin float alpha;\nout float a;"),
        "place = position;", "place = position, a = alpha;");
    const std::string fragment =
        replacedIn(replacedIn(kCulledFragment, "out vec4", "in float a;\nout vec4"), "1.0);\n}", "a);\n}");
    return makeProgram(gl, vertex, fragment);
  };
  drawn.prepare = [=](Gl gl, GLuint program) {
    const std::vector<float> values(shells(5, 100).positions.size(), alpha);
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data(),
                  GL_STATIC_DRAW);
    const auto location = static_cast<GLuint>(gl.GetAttribLocation(program, "alpha"));
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
    // Each hundredth triangle is a restart index three times.
    ProgramMesh mesh = shells(5, 100);
    for (size_t i = 0; i + 3 <= mesh.indices.size(); i += 300)
      std::fill_n(mesh.indices.begin() + static_cast<ptrdiff_t>(i), 3, ~0u);
    gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0,
                     static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(GLuint)), mesh.indices.data());
  };
  drawn.state = [](Gl gl, GLuint) {
    gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(~0u);
  };
  return drawn;
}

TEST(RareCulledState, AnIndexThatRestartsHasNoAlpha) {
  EXPECT_GT(compareDrawn("restart_ones", tinted(1)).drawsCulled, 0u);
  EXPECT_EQ(compareDrawn("restart_halves", tinted(0.5f)).drawsCulled, 0u);
}

TEST(RareCulledState, DrawBuffersAfterOneThatIsOff) {
  GLuint framebuffer = 0;
  Drawn drawn;
  drawn.make = [](Gl gl) {
    const std::string fragment =
        replacedIn(replacedIn(kCulledFragment, "out vec4 color;", "out vec4 color[3];"),
                   "color = ", "color[2] = color[0] = ");
    return makeProgram(gl, kCulledVertex, fragment);
  };
  drawn.prepare = [&](Gl gl, GLuint) {
    std::array<GLuint, 4> images{};
    gl.GenRenderbuffers(4, images.data()), gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    for (GLuint i = 0; i < 4; ++i) {
      gl.BindRenderbuffer(GL_RENDERBUFFER, images[i]);
      gl.RenderbufferStorage(GL_RENDERBUFFER, i == 3 ? GL_DEPTH_COMPONENT24 : GL_RGBA8, kSide, kSide);
      gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, i == 3 ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0 + i,
                                 GL_RENDERBUFFER, images[i]);
    }
    constexpr std::array<GLenum, 3> kGap{GL_COLOR_ATTACHMENT0, GL_NONE, GL_COLOR_ATTACHMENT2};
    gl.DrawBuffers(3, kGap.data());
    EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  };
  EXPECT_EQ(compareDrawn("gap", drawn).drawsCulled, 0u);
}

/// The real OpenGL sets them all to the first subroutine when a program comes into use.
TEST(RareCulledState, SubroutinesStayAsTheyAreSet) {
  Drawn drawn;
  drawn.wish = kNewest, drawn.samples = 4, drawn.draws = 2;
  drawn.make = [](Gl gl) {
    std::string fragment = replacedIn(kCulledFragment, "#version 150", "#version 400");
    fragment = replacedIn(fragment, "float wood(vec3 p) {",
                          "subroutine float Pattern(vec3 p);\nsubroutine uniform Pattern wood;\n"
                          "subroutine(Pattern) float plain(vec3 p) { return 0.0; }\n"
                          "subroutine(Pattern) float grained(vec3 p) {");
    return makeProgram(gl, replacedIn(kCulledVertex, "#version 150", "#version 400"), fragment);
  };
  drawn.state = [](Gl gl, GLuint program) {
    const GLuint grained = gl.GetSubroutineIndex(program, GL_FRAGMENT_SHADER, "grained");
    const GLuint plain = gl.GetSubroutineIndex(program, GL_FRAGMENT_SHADER, "plain");
    GLuint first = plain;  // what the program comes into use with
    gl.GetUniformSubroutineuiv(GL_FRAGMENT_SHADER, 0, &first);
    const GLuint other = first == plain ? grained : plain;
    gl.UniformSubroutinesuiv(GL_FRAGMENT_SHADER, 1, &other);
  };
  EXPECT_GT(compareDrawn("subroutines", drawn).drawsCulled, 0u);
}

/// It lives on until another program is in use.
TEST(RareCulledState, ProgramsThatAreDeletedWhileInUse) {
  const std::string waves = replacedIn(kCulledVertex, "vec4(position, 1.0)",
                                       "vec4(position * (1.0 + 0.1 * sin(9.0 * position.y)), 1.0)");
  const ProgramMesh mesh = shells(5, 100);
  for (const std::string& vertex : {std::string(kCulledVertex), waves})
    for (const int samples : {1, 4}) {
      const std::string name = (vertex == waves ? "rare_fed_back" : "rare_deleted") + std::to_string(samples);
      std::array<GLuint, 3> programs{};
      GLuint array = 0;
      const gl::Statistics counts = compareSamples(
          name, 3, samples, GL_DEPTH24_STENCIL8,
          [&](Gl gl) {
            for (GLuint& program : programs) program = makeProgram(gl, vertex, kCulledFragment);
            array = send(gl, mesh, programs[0]).array;
          },
          [&](Gl gl, int frame) {
            clear(gl);
            const GLuint program = programs[static_cast<size_t>(frame)];
            gl.UseProgram(program), gl.DeleteProgram(program);
            gl.BindVertexArray(array);
            for (int i = 0; i < 3; ++i) {
              turn(gl, program, frame + 3 * i);
              gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
            }
            GLint current = 0;
            gl.GetIntegerv(GL_CURRENT_PROGRAM, &current);
            EXPECT_EQ(static_cast<GLuint>(current), program);
          },
          nullptr, kNewest);
      EXPECT_GT(counts.drawsCulled, 0u) << name;
    }
}

void radialFog(Gl gl) { gl.Enable(GL_FOG), gl.Fogi(GL_FOG_DISTANCE_MODE_NV, GL_EYE_RADIAL_NV); }

/// Fog of a kind that is not traced may be culled; other state beside it may not.
TEST(RareCulledState, OtherStateBesideRadialFog) {
  const ProgramMesh mesh = shells(5, 60);
  const auto culledWith = [&](const std::string& name, const std::function<void(Gl)>& state) {
    return compareFrames(
               "fog_" + name, 4, [](Gl) {},
               [&](Gl gl, int frame) {
                 gl.DepthMask(GL_TRUE);
                 radialFog(gl);
                 state(gl);
                 drawByFixedFunction(gl, mesh, frame, GL_TRIANGLES, mesh.indices);
               },
               nullptr, {kSide, kSide})
        .drawsCulled;
  };
  EXPECT_GT(culledWith("alone", [](Gl) {}), 0u);
  EXPECT_EQ(culledWith("lines", [](Gl gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); }), 0u);
  EXPECT_EQ(culledWith("coverage", [](Gl gl) { gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE); }), 0u);
  EXPECT_EQ(culledWith("clamp", [](Gl gl) { gl.Enable(GL_DEPTH_CLAMP); }), 0u);
  EXPECT_EQ(culledWith("sum", [](Gl gl) { gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE); }), 0u);
}

/// The text that is included decides where vertices are.
TEST(RareCulledState, ShadersThatIncludeTexts) {
  Drawn drawn;
  drawn.wish = kNewest;
  bool has = true;
  drawn.make = [&](Gl gl) -> GLuint {
    has = gl::hasExtension(gl, gl::versionOf(gl), "GL_ARB_shading_language_include");
    if (!has) return makeProgram(gl, kCulledVertex, kCulledFragment);
    gl.NamedStringARB(GL_SHADER_INCLUDE_ARB, -1, "/waves.glsl", -1, "#define WAVES 1\n");
    const std::string vertex =
        replacedIn(replacedIn(kCulledVertex, "#version 150",
                              "#version 150\n#extension GL_ARB_shading_language_include : require\n"
                              "#include \"/waves.glsl\""),
                   "vec4 eye = eyeFromObject * vec4(position, 1.0);",
                   "\n#ifdef WAVES\n  vec4 eye = eyeFromObject * vec4(0.3 * position + vec3(sin(position.y), "
                   "0, 0), 1.0);"
                   "\n#else\n  vec4 eye = eyeFromObject * vec4(position, 1.0);\n#endif\n");
    return makeProgram(gl, vertex, kCulledFragment);
  };
  const uint64_t culled = compareDrawn("include", drawn).drawsCulled;
  if (!has) GTEST_SKIP() << "the real OpenGL includes no texts";
  EXPECT_EQ(culled, 0u);
}

}  // namespace
}  // namespace gluray::test::rare_culled_state

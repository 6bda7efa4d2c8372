#include "gl/culled/shader_slice/position_slice.h"

#include "gl/testing/test_uniforms.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <map>
#include <random>

namespace gluray::gl {
namespace {

using test::FakeUniforms;

glm::dmat4 matrix(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<float> number(-2, 2);
  glm::dmat4 m;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) m[c][r] = static_cast<double>(number(random));
  return m;
}

FakeUniforms usual() {
  FakeUniforms u;
  u.set("P", matrix(1)), u.set("V", matrix(2)), u.set("M", matrix(3));
  u.values["offset"] = {1, 2, 3}, u.values["scale"] = {2}, u.values["on"] = {1}, u.values["count"] = {2};
  return u;
}

std::optional<LinearPosition> positionOf(const std::string& text, const FakeUniforms& uniforms = usual()) {
  std::string why;
  auto result = PositionSlice(text).evaluate(uniforms, why);
  EXPECT_EQ(why.empty(), result.has_value()) << why;
  return result;
}

void expectMatrix(const std::string& text, const glm::dmat4& expected, const std::string& attribute = "p",
                  const FakeUniforms& uniforms = usual()) {
  SCOPED_TRACE(text);
  std::string why;
  const auto got = PositionSlice(text).evaluate(uniforms, why);
  ASSERT_TRUE(got) << why;
  EXPECT_EQ(got->attribute, attribute);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) {
      EXPECT_NEAR(got->clipFromAttribute[c][r], expected[c][r], 1e-6 * (1 + got->magnitudes[c][r])) << c << r;
      EXPECT_GE(got->magnitudes[c][r], std::abs(expected[c][r]) * (1 - 1e-9));
    }
}

void expectUnknown(const std::string& text) {
  SCOPED_TRACE(text);
  EXPECT_FALSE(positionOf(text));
}

const std::string kHead =
    "uniform mat4 P, V, M; uniform vec3 offset; uniform float scale; uniform bool on; "
    "uniform int count; in vec3 p; in vec4 q; in vec3 other;\n";

TEST(PositionSlice, FollowsProducts) {
  const FakeUniforms u = usual();
  const glm::dmat4 P = matrix(1), V = matrix(2), M = matrix(3);
  expectMatrix(kHead + "void main() { gl_Position = P * V * M * vec4(p, 1.0); }", P * V * M);
  expectMatrix(kHead + "void main() { vec4 eye = V * (M * vec4(p, 1)); gl_Position = P * eye; }", P * V * M);
  expectMatrix(kHead + "void main() { gl_Position = P * q; }", P, "q");
  expectMatrix(kHead + "void main() { gl_Position = q * P; }", glm::transpose(P), "q");
  expectMatrix(kHead + "void main() { gl_Position = transpose(P) * q; }", glm::transpose(P), "q");
  expectMatrix(kHead + "void main() { gl_Position = inverse(P) * q; }", glm::inverse(P), "q");
  const glm::dmat4 moved =
      P * glm::translate(glm::dmat4(1), {1, 2, 3}) * glm::scale(glm::dmat4(1), glm::dvec3(2));
  expectMatrix(kHead + "void main() { gl_Position = P * vec4(scale * p + offset, 1.0); }", moved);
  expectMatrix(
      kHead + "void main() { vec3 a = p; a *= scale; a += offset; gl_Position = P * vec4(a.xy, a.z, 1.); }",
      moved);
  const glm::dmat4 turned = P * glm::dmat4(glm::dmat3(M));
  expectMatrix(kHead + "void main() { gl_Position = P * vec4(mat3(M) * p, 1.0); }", turned);
}

TEST(PositionSlice, FollowsWhatIsKnown) {
  const glm::dmat4 P = matrix(1), V = matrix(2);
  expectMatrix(kHead + "vec4 f(vec3 a) { return V * vec4(a, 1.0); } void main() { gl_Position = P * f(p); }",
               P * V);
  expectMatrix(kHead +
                   "void f(in vec3 a, out vec4 b) { b = V * vec4(a, 1.0); } void main() { vec4 b; f(p, b); "
                   "gl_Position = P * b; }",
               P * V);
  expectMatrix(
      kHead + "void main() { if (on) gl_Position = P * vec4(p, 1.0); else gl_Position = vec4(other, 1.0); }",
      P);
  expectMatrix(kHead +
                   "void main() { vec3 a = vec3(0.0); for (int i = 0; i < count; ++i) a += p; gl_Position = "
                   "P * vec4(a, 1.0); }",
               P * glm::scale(glm::dmat4(1), glm::dvec3(2)));
  expectMatrix(kHead +
                   "#define POS vec4(p, 1.0)\n#define MUL(a, b) ((a) * (b))\n#if __VERSION__ >= 100 && "
                   "!defined(NOT)\nvoid main() { gl_Position = MUL(P, POS); }\n#endif\n",
               P);
  expectMatrix(kHead +
                   "void main() { float w = length(p) + sin(p.x); if (w > 1.0) w = 2.0; vec3 c = vec3(w); "
                   "gl_Position = P * vec4(p, 1.0); gl_PointSize = w; }",
               P);
  expectMatrix(kHead +
                   "out vec3 n; void main() { n = p; vec4 t = vec4(p, 1.0); t.xy = t.yx; t.xy = t.yx; "
                   "gl_Position = P * t; }",
               P);
  expectMatrix(kHead + "void main() { gl_Position = P * vec4(p, 1.0); vec4 p = vec4(1.0); }", P);
  expectMatrix(kHead +
                   "float srgb(float x) { if (x < 0.04) return x; return pow(x, 2.2); } out float c; void "
                   "main() { c = srgb(other.x); gl_Position = P * vec4(p, 1.0); }",
               P);
  expectMatrix(kHead + "void main() { gl_Position = P * vec4(mix(p, p + offset, 0.0), 1.0); }", P);
}

/// The real OpenGL multiplies both matrices: rounding is relative to the summands of that product.
TEST(PositionSlice, KnowsHowBuiltInMatricesAreMade) {
  FakeUniforms u;
  const glm::dmat4 projection = matrix(1), view = matrix(2);
  u.set("gl_ProjectionMatrix", projection), u.set("gl_ModelViewMatrix", view);
  glm::dmat4 sizes[] = {projection, view};
  for (glm::dmat4& m : sizes)
    for (int c = 0; c < 4; ++c) m[c] = glm::abs(m[c]);
  const glm::dmat4 most = sizes[0] * sizes[1];
  for (const char* const position : {"ftransform()", "gl_ModelViewProjectionMatrix * gl_Vertex"}) {
    const std::string text = "void main() { gl_Position = " + std::string(position) + "; }";
    expectMatrix(text, projection * view, "gl_Vertex", u);
    const auto got = positionOf(text, u);
    ASSERT_TRUE(got);
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) EXPECT_GE(got->magnitudes[c][r], most[c][r] * (1 - 1e-9));
  }
}

TEST(PositionSlice, FollowsBlocksStructsAndArrays) {
  FakeUniforms u = usual();
  const glm::dmat4 A = matrix(7);
  u.set("Camera.matrix", A), u.set("bones[1]", A), u.set("lights[1].place.m", A), u.set("m", A);
  expectMatrix(
      "uniform Camera { mat4 matrix; vec3 eye; } camera; in vec3 p; void main() { gl_Position = "
      "camera.matrix * vec4(p, 1.0); }",
      A, "p", u);
  expectMatrix(
      "layout(std140) uniform Camera { mat4 m; }; in vec3 p; void main() { gl_Position = m * vec4(p, 1.0); }",
      A, "p", u);
  expectMatrix("uniform mat4 bones[3]; in vec3 p; void main() { gl_Position = bones[1] * vec4(p, 1.0); }", A,
               "p", u);
  expectMatrix(
      "struct Place { mat4 m; }; struct Light { vec3 color; Place place; }; uniform Light lights[2]; in vec3 "
      "p; void main() { gl_Position = lights[1].place.m * vec4(p, 1.0); }",
      A, "p", u);
  u.set("gl_ProjectionMatrix", A), u.set("gl_ModelViewMatrix", glm::dmat4(1));
  expectMatrix("varying vec3 n; void main() { n = gl_NormalMatrix * gl_Normal; gl_Position = ftransform(); }",
               A, "gl_Vertex", u);
  expectMatrix("void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }", A, "gl_Vertex", u);
}

TEST(PositionSlice, RefusesWhatIsNotLinear) {
  expectUnknown(kHead + "void main() { gl_Position = P * vec4(p + other, 1.0); }");
  expectUnknown(kHead + "void main() { gl_Position = P * vec4(p * p, 1.0); }");
  expectUnknown(kHead + "void main() { gl_Position = P * vec4(normalize(p), 1.0); }");
  expectUnknown(kHead +
                "void main() { gl_Position = P * vec4(p, 1.0); if (other.x > 0.0) gl_Position.z = 0.0; }");
  expectUnknown(kHead +
                "void main() { gl_Position = P * vec4(p, 1.0); gl_Position.z = log2(gl_Position.w); }");
  expectUnknown(kHead + "void main() { gl_Position = P * vec4(p, 1.0) + vec4(float(gl_InstanceID)); }");
  expectUnknown(
      kHead + "uniform sampler2D t; void main() { gl_Position = P * vec4(p.xy, texture(t, p.xy).x, 1.0); }");
  expectUnknown(
      kHead +
      "void main() { if (p.x > 0.0) { gl_Position = vec4(2.0); return; } gl_Position = P * vec4(p, 1.0); }");
  expectUnknown(kHead +
                "void f() { gl_Position = vec4(other, 1.0); } void main() { gl_Position = P * vec4(p, 1.0); "
                "if (other.x > 0.0) f(); }");
  expectUnknown(kHead +
                "vec3 f(vec3 a) { if (a.x > 0.0) return a; return 2.0 * a; } void main() { gl_Position = P * "
                "vec4(f(p), 1.0); }");
  expectUnknown(kHead + "void main() { gl_Position = P * vec4(p, 1.0); gl_Position /= gl_Position.w; }");
  expectUnknown(kHead +
                "void main() { vec3 a = p; int i = 0; while (float(i) < other.x) { a += p; ++i; } "
                "gl_Position = P * vec4(a, 1.0); }");
  expectUnknown(kHead + "void f(vec3 a) { f(a); } void main() { f(p); gl_Position = P * vec4(p, 1.0); }");
  expectUnknown(kHead + "void main() { gl_Position = unknownFunction(P * vec4(p, 1.0)); }");
  expectUnknown(kHead + "void main() { gl_Position = P * vec4(p, 1.0); unknownFunction(); }");
  expectUnknown(kHead + "void main() { gl_Position = vec4(0.0); }");
  expectUnknown(kHead + "void main() { gl_Position = P * (q + vec4(0.0, 0.0, 0.0, 1.0)); }");
  expectUnknown(kHead +
                "void main() { vec3 a = p; bool b = other.x > 0.0 && (a = other).x > 0.0; gl_Position = P * "
                "vec4(a, 1.0); }");
  expectUnknown(kHead +
                "void main() { vec3 a = other.x > 0.0 ? p : 2.0 * p; gl_Position = P * vec4(a, 1.0); }");
  expectUnknown(kHead +
                "void main() { switch (count) { case 2: gl_Position = P * vec4(p, 1.0); break; default: "
                "gl_Position = vec4(p, 1.0); } }");
  expectUnknown(kHead +
                "#ifdef GL_ARB_anything\nvoid main() { gl_Position = vec4(p, 1.0); }\n#else\nvoid main() { "
                "gl_Position = P * vec4(p, 1.0); }\n#endif\n");
  expectUnknown(kHead + "#include \"/config.glsl\"\nvoid main() { gl_Position = P * vec4(p, 1.0); }");
  expectUnknown("in vec3 p; uniform mat4 missing; void main() { gl_Position = missing * vec4(p, 1.0); }");
}

// Long chains make deep trees, which are visited and freed by recursion.
TEST(PositionSlice, RefusesLongChains) {
  for (const std::string link : {" + 0.0 * p.x", ", p.x", " * 1.0", ".x"}) {
    std::string chain = "p.x";
    for (int i = 0; i < 200'000; ++i) chain += link;
    expectUnknown(kHead + "void main() { gl_Position = P * vec4((" + chain + "), p.yz, 1.0); }");
    expectUnknown(kHead + "float f(float a) { return a; } void main() { gl_Position = P * vec4(f(f(" + chain +
                  ")), p.yz, 1.0); }");
  }
}

// Nesting as deep as the parser accepts, and functions that call each other, on a thread with 64 kB of stack.
TEST(PositionSlice, DeepShadersFitSmallStacks) {
  std::string body = "p.x", functions = "float f0(float a) { return a; } ";
  for (int i = 0; i < 90; ++i) body = "(" + body + ")";
  for (int i = 1; i < 30; ++i)
    functions +=
        "float f" + std::to_string(i) + "(float a) { return ((((f" + std::to_string(i - 1) + "(a))))); } ";
  static std::string text;
  text = kHead + functions + "void main() { gl_Position = P * vec4(f29(" + body + "), p.yz, 1.0); }";
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, size_t{64} << 10);
  pthread_t thread;
  const auto run = [](void*) -> void* {
    const FakeUniforms u = usual();
    std::string why;
    PositionSlice(text).evaluate(u, why);
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, run, nullptr), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

TEST(PositionSlice, SurvivesAnyText) {
  const std::string text =
      kHead +
      "#define F(a, b) ((a) * (b))\nstruct S { mat4 m[2]; };\nvec4 f(inout vec4 a) { for (int i = 0; "
      "i < 3; i++) { a.xyz *= 2.0; if (on) continue; } return a; }\nvoid main() { vec4 t = vec4(p, "
      "1.0); S s; s.m[0] = P; gl_Position = F(s.m[0], f(t)) + (on ? vec4(0) : t); }";
  std::mt19937 random(5);
  const std::string letters = "(){}[];,.=+-*/<>&|!?:# \nabcdxyz019_";
  const FakeUniforms u = usual();
  for (int round = 0; round < 20000; ++round) {
    std::string mutated = text;
    for (unsigned edits = 1 + random() % 6; edits > 0; --edits) {
      const size_t at = random() % mutated.size();
      switch (random() % 4) {
        case 0: mutated[at] = letters[random() % letters.size()]; break;
        case 1: mutated.erase(at, 1 + random() % 8); break;
        case 2: mutated.insert(at, mutated.substr(random() % mutated.size(), random() % 40)); break;
        default: mutated.insert(at, 1, letters[random() % letters.size()]); break;
      }
    }
    std::string why;
    PositionSlice(mutated).evaluate(u, why);
  }
}

}  // namespace
}  // namespace gluray::gl

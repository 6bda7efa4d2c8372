// Functions of shaders are evaluated as the OpenGL shading language says, or refused.
#include "gl/glsl/functions/shader_functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gluray::gl::glsl {
namespace {

/// Uniforms u (a vector 2, 3, 4, 5), s (0.5) and m (a matrix with 1 to 16, column by column).
FunctionInputs someInputs() {
  FunctionInputs inputs;
  inputs.uniform = [](std::string_view name) -> std::optional<FunctionValue> {
    if (name == "u") return FunctionValue::vector({2, 3, 4, 5}, 4);
    if (name == "s") return FunctionValue::number(0.5);
    FunctionValue matrix;
    matrix.size = FunctionValue::kMatrix;
    for (int i = 0; i < 16; ++i) matrix.matrix[i / 4][i % 4] = i + 1;
    return name == "m" ? std::optional(matrix) : std::nullopt;
  };
  inputs.texture = [](std::string_view sampler, const glm::dvec2& at) -> std::optional<glm::dvec4> {
    return sampler == "t" ? std::optional(glm::dvec4(at, 7, 8)) : std::nullopt;
  };
  return inputs;
}

constexpr const char* kUniforms =
    "#version 120\nuniform vec4 u; uniform float s; uniform mat4 m; uniform mat4 n; uniform sampler2D t;\n";

glm::dvec4 colorAt(const std::string& body, double at = 0.25) {
  return ShaderFunctions(kUniforms + ("vec4 f(float t0) {" + body + "}")).colorOf("f", at, someInputs());
}

glm::dmat4 matrixOf(const std::string& text) {
  return ShaderFunctions(kUniforms + text).matrixOf("f", someInputs());
}

TEST(ShaderFunctions, Arithmetic) {
  EXPECT_EQ(colorAt("return vec4(t0, 1 - t0, t0 * 2.0 + 1.0, -t0 / 2.0);"),
            glm::dvec4(0.25, 0.75, 1.5, -0.125));
  EXPECT_EQ(colorAt("return u * s + vec4(t0);"), glm::dvec4(1.25, 1.75, 2.25, 2.75));
  EXPECT_EQ(colorAt("return u.wzyx;"), glm::dvec4(5, 4, 3, 2));
  EXPECT_EQ(colorAt("return vec4(u.rg, u.ba.yx);"), glm::dvec4(2, 3, 5, 4));
}

TEST(ShaderFunctions, BuiltInFunctions) {
  EXPECT_EQ(colorAt("return mix(vec4(0.0), u, t0);"), glm::dvec4(0.5, 0.75, 1, 1.25));
  EXPECT_EQ(colorAt("return clamp(u, 2.5, 4.5);"), glm::dvec4(2.5, 3, 4, 4.5));
  EXPECT_EQ(colorAt("return vec4(smoothstep(0.0, 0.5, t0), step(0.25, t0), step(0.3, t0), sqrt(t0));"),
            glm::dvec4(0.5, 1, 0, 0.5));
  EXPECT_EQ(colorAt("return vec4(pow(t0, 0.5), min(t0, 0.1), max(t0, 0.1), mod(1.75, 1.0));"),
            glm::dvec4(0.5, 0.1, 0.25, 0.75));
}

TEST(ShaderFunctions, Statements) {
  const std::string body =
      "float a = t0; if (a < 0.5) { a = 2.0; } else a = 3.0; vec4 c = vec4(a); c.gb *= vec2(2.0, 3.0); "
      "return c;";
  EXPECT_EQ(colorAt(body), glm::dvec4(2, 4, 6, 2));
  EXPECT_EQ(colorAt(body, 0.75), glm::dvec4(3, 6, 9, 3));
  EXPECT_EQ(colorAt("return t0 > 1.0 ? vec4(1.0) : vec4(2.0);"), glm::dvec4(2));
  const std::string nan = "if (!(t0 <= 0.0 || 0.0 <= t0)) { return vec4(9.0); } return vec4(1.0);";
  EXPECT_EQ(colorAt(nan), glm::dvec4(1));
  EXPECT_EQ(colorAt(nan, std::nan("")), glm::dvec4(9));
}

TEST(ShaderFunctions, TexturesAndOtherFunctions) {
  EXPECT_EQ(colorAt("return texture2D(t, vec2(0.0, clamp(t0, 0.0, 1.0)));"), glm::dvec4(0, 0.25, 7, 8));
  const ShaderFunctions two(
      "float half_of(float x) { return x * 0.5; }\nvec4 f(float x) { return vec4(half_of(half_of(x))); }");
  EXPECT_EQ(two.colorOf("f", 2, someInputs()), glm::dvec4(0.5));
}

TEST(ShaderFunctions, MatricesOfLinearFunctions) {
  EXPECT_EQ(matrixOf("vec4 f(vec4 p) { return p; }"), glm::dmat4(1));
  glm::dmat4 moved(1);
  moved[0][0] = 2, moved[1][1] = 3, moved[2][2] = 4, moved[3] = {2, 3, 4, 1};
  EXPECT_EQ(matrixOf("vec4 f(vec4 p) { return vec4(p.xyz * u.xyz + u.xyz * p.w, p.w); }"), moved);
  const glm::dmat4 back = matrixOf("vec4 f(vec4 p) { return vec4((p.xyz - u.xyz * p.w) / u.xyz, p.w); }");
  for (int i = 0; i < 16; ++i) EXPECT_NEAR((back * moved)[i / 4][i % 4], i % 5 == 0, 1e-15);
  const glm::dmat4 m = someInputs().uniform("m")->matrix;
  EXPECT_EQ(
      matrixOf(
          "vec4 g(vec4 p) { return m * p; }\nvec4 f(vec4 p) { vec4 r = g(p); vec4 q = g(r); return q; }"),
      m * m);
}

TEST(ShaderFunctions, RefuseWhatIsNotLinear) {
  for (const char* body : {"return p * p.x;", "return vec4(p.xyz, 1.0);", "return vec4(sqrt(p.x), p.yzw);",
                           "return p / p.w;", "return p.x > 0.0 ? p : p;", "p.x = 1.0; return p;"})
    EXPECT_THROW(matrixOf("vec4 f(vec4 p) {" + std::string(body) + "}"), std::runtime_error) << body;
}

TEST(ShaderFunctions, RefuseWhatIsNotUnderstood) {
  for (const char* body :
       {"for (int i = 0; i < 3; ++i) t0 += 1.0; return vec4(t0);", "return vec4(unknown);",
        "return vec4(noise1(t0));", "return n * u;", "return vec4(1 / 2);",
        "return vec4(texture2D(q, vec2(t0)).r);", "return vec4(t0, 1.0, 2.0);",
        "float a[2]; return vec4(t0);", "discard; return vec4(t0);", "", "return vec3(t0);",
        "int i = t0; return vec4(i);", "return u.xyq;", "return vec4(010);", "t0++; return vec4(t0);"})
    EXPECT_THROW(colorAt(body), std::runtime_error) << body;
  EXPECT_THROW(ShaderFunctions("vec4 f(float a) { return f(a); }").colorOf("f", 1, someInputs()),
               std::runtime_error);
  EXPECT_THROW(ShaderFunctions("vec4 f(float a) { return vec4(a); } vec4 f(vec2 a) { return vec4(1.0); }")
                   .colorOf("f", 1, someInputs()),
               std::runtime_error);
  EXPECT_THROW(ShaderFunctions("vec4 f(").colorOf("f", 1, someInputs()), std::runtime_error);
}

}  // namespace
}  // namespace gluray::gl::glsl

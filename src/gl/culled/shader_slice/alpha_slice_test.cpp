#include "gl/culled/shader_slice/position_slice.h"
#include "gl/testing/test_uniforms.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

using test::FakeUniforms;

FakeUniforms withUniforms() {
  FakeUniforms u;
  u.values["scale"] = {2}, u.values["on"] = {1}, u.values["minus"] = {-3}, u.values["half"] = {0.5};
  return u;
}

bool isOpaque(const std::string& text) {
  const Opacity opacity = AlphaSlice(text).opacity(withUniforms());
  return opacity.exact && opacity.ones.empty();
}

TEST(AlphaSlice, KnowsAlphaOfOne) {
  EXPECT_TRUE(isOpaque("void main() { gl_FragColor = vec4(gl_Color.rgb, 1.0); }"));
  EXPECT_TRUE(
      isOpaque("uniform sampler2D s; varying vec2 t;"
               "void main() { gl_FragColor = vec4(texture2D(s, t).rgb, 1.0); }"));
  EXPECT_TRUE(isOpaque("varying vec3 c; void main() { gl_FragData[0] = vec4(c, 1.0); }"));
  EXPECT_TRUE(isOpaque("#version 330\nin vec3 c; out vec4 o; void main() { o.rgb = c; o.a = 1.0; }"));
  EXPECT_TRUE(isOpaque("uniform float on; out vec4 o; in vec4 c; void main() { o = c; o.a = on; }"));
  EXPECT_TRUE(isOpaque("out vec4 o; in vec4 c; void main() { if (c.x > 0.0) discard; o = vec4(1); }"));
}

TEST(AlphaSlice, KnowsNoOther) {
  EXPECT_FALSE(isOpaque("void main() { gl_FragColor = gl_Color; }"));
  EXPECT_FALSE(isOpaque("void main() { gl_FragColor = vec4(1.0, gl_Color.rgb); }"));
  EXPECT_FALSE(isOpaque("void main() { gl_FragColor = vec4(gl_Color.rg, gl_TexCoord[0].x, 0.5 + 0.4); }"));
  EXPECT_FALSE(isOpaque("void main() { gl_FragColor = vec4(gl_Color.rgb, 0.5); }"));
  EXPECT_FALSE(isOpaque("uniform float scale; out vec4 o; void main() { o = vec4(1, 1, 1, scale); }"));
  EXPECT_FALSE(isOpaque("out vec4 o; in vec4 c; void main() { o = vec4(1); if (c.x > 0.0) o = c; }"));
  EXPECT_FALSE(isOpaque("out vec4 o, p; void main() { o = p = vec4(1); }"));
  EXPECT_FALSE(isOpaque("out uvec4 o; void main() { o = uvec4(1); }"));
  EXPECT_FALSE(isOpaque("in vec4 c; out vec4 o; void main() { o = c; return; o = vec4(1); }"));
  EXPECT_FALSE(isOpaque("out vec4 o; void main() { if (c.x > 0.0) return; o = vec4(1); }"));
}

/// Declarations of varyings and uniforms for fragment shaders.
const std::string kIn =
    "uniform float scale, on, minus, half; uniform sampler2D map; in vec4 c; in vec3 n; in float s;\n";

Opacity of(const std::string& body, const Varyings& varyings = {}) {
  return AlphaSlice(kIn + (body.find("gl_Frag") == std::string::npos ? "out vec4 o;" : "") + body)
      .opacity(withUniforms(), varyings);
}

TEST(AlphaSlice, KnowsBoundsOfAlpha) {
  for (const char* const alpha :
       {"1.0 + clamp(dot(n, n), 0.0, 1.0)", "on + scale * max(0.0, s)", "0.25 * 4.0", "max(s, 1.0)",
        "max(1.0, s)", "clamp(s, on, scale)", "1.0 + pow(clamp(s, 0.0, 1.0), scale)",
        "1.0 + length(clamp(n, -1.0, 1.0))", "mix(1.0, 2.0, smoothstep(0.0, 1.0, s))",
        "1.0 + abs(clamp(s, -2.0, 1.0))", "2.0 + sin(clamp(s, 0.0, 9.0))", "s > 0.5 ? 1.0 : 3.0", "on * on",
        "1.0 + step(s, 0.5)", "2.0 - fract(clamp(s, -4.0, 4.0))", "sqrt(1.0 + clamp(s, 0.0, 5.0))", "-minus",
        "1.0 - minus * clamp(n.x, 0.0, 1.0)", "4.0 / (1.0 + clamp(s, 0.0, 3.0)) "}) {
    const Opacity opacity = of("void main() { o = vec4(n, " + std::string(alpha) + "); }");
    EXPECT_TRUE(opacity.opaque) << alpha;
    EXPECT_FALSE(opacity.exact && std::string(alpha).find('s') != std::string::npos) << alpha;
    EXPECT_TRUE(opacity.ones.empty());
  }
  EXPECT_TRUE(of("void main() { gl_FragColor = vec4(1.0 + clamp(s, 0.0, 1.0)); }").opaque);
  EXPECT_TRUE(of("void main() { gl_FragData[0] = vec4(1.0 + clamp(s, 0.0, 1.0)); }").opaque);
}

TEST(AlphaSlice, KnowsWhereBoundsAreTooLow) {
  for (const char* const alpha : {"s",
                                  "1.0 + s",
                                  "max(s, 0.99)",
                                  "min(1.0, s)",
                                  "1.0 + normalize(n).x",
                                  "pow(s, 2.0)",
                                  "1.0 + pow(s, 2.0)",
                                  "1.0 - clamp(s, 0.0, 1.0)",
                                  "1.0 + sin(s)",
                                  "1.0 + s * s",
                                  "texture(map, n.xy).a",
                                  "1.0 + dot(n, n)",
                                  "mix(1.0, half, s)",
                                  "mix(1.0, 1.0, s)",
                                  "1.0 / max(s, 0.0)",
                                  "1.0 + fract(s)",
                                  "1.0 + length(n)",
                                  "1.0 + abs(s)",
                                  "1.0 + sqrt(s)",
                                  "1.0 + max(s, s)",
                                  "s > 0.5 ? 1.0 : half",
                                  "1.0 + 0.0 * s",
                                  "1.0 + 0.0 * max(s, 0.0)",
                                  "half + half * clamp(s, 0.0, 1.0)",
                                  "1.0 + minus * clamp(s, 0.0, 1.0)",
                                  "1.0 + exp(s)",
                                  "2.0 - exp(clamp(s, 0.0, 0.1))",
                                  "1.0 + 1.0 / (s - 1.0)"})
    EXPECT_FALSE(of("void main() { o = vec4(n, " + std::string(alpha) + "); }").opaque) << alpha;
}

TEST(AlphaSlice, FollowsBothSidesOfBranches) {
  for (const char* const body :
       {"void main() { o = c; if (s > 0.5) o.a = 1.0; else o.a = 2.0; }",
        "void main() { o = vec4(n, 1.0); if (s > 0.5) o.rgb = c.rgb; }",
        "void main() { vec4 k = vec4(1.0); if (n.x > 0.0) { if (n.y > 0.0) k.r = s; else k.g = s; } o = k; }",
        "vec4 fog(vec4 k) { if (s > 1.0) return k; return vec4(n, k.a); } void main() { o = fog(vec4(1.0)); "
        "}",
        "vec4 fog(vec4 k) { if (s > 1.0) { k.a = 3.0; return k; } else if (s > 0.0) return vec4(1.0); k.a += "
        "1.0;"
        " return k; } void main() { o = fog(vec4(1.0)); }",
        "void main() { o = vec4(n, 1.0); if (s < 0.0) return; o.rgb = vec3(0.0); }",
        "void light(inout vec4 k) { if (s > 0.0) return; k.rgb = n; } void main() { o = vec4(1.0); light(o); "
        "}",
        "void main() { if (s < 0.0) discard; o = vec4(n, 1.0); }",
        "void main() { o = vec4(n, 1.0); for (int i = 0; i < 3; ++i) if (s > float(i)) o.r += 0.1; }",
        "vec4 k() { for (int i = 0; i < 3; ++i) if (s > float(i)) return vec4(1.0); return vec4(n, 1.0); }"
        "void main() { o = k(); }"})
    EXPECT_TRUE(of(body).opaque) << body;
  for (const char* const body :
       {"void main() { o = vec4(1.0); if (s > 0.5) o.a = 0.5; }",
        "void main() { o = vec4(1.0); if (s > 0.5) o.rgb = n; else o = c; }",
        "vec4 fog(vec4 k) { if (s > 1.0) return vec4(0.5); return k; } void main() { o = fog(vec4(1.0)); }",
        "void main() { o = vec4(n, 0.5); if (s < 0.0) return; o.a = 1.0; }",
        "void main() { if (s < 0.0) { o = c; return; } o = vec4(1.0); }",
        "void dim(inout vec4 k) { if (s > 0.0) { k.a = 0.5; return; } k.a = 1.0; }"
        "void main() { o = vec4(1.0); dim(o); }",
        "float a = 1.0; void f() { if (s > 0.0) { a = 0.5; return; } } void main() { f(); o = vec4(n, a); }",
        "vec4 k() { for (int i = 0; i < 3; ++i) if (s > float(i)) return c; return vec4(1.0); }"
        "void main() { o = k(); }",
        "void main() { o = vec4(1.0); for (int i = 0; i < 3; ++i) { if (s > float(i)) break; o.a = 0.5; } }",
        "void main() { o = vec4(1.0); for (float i = 0.0; i < s; ++i) o.a *= 0.5; }"})
    EXPECT_FALSE(of(body).opaque) << body;
}

/// A long part that is irrelevant does not make the whole shader unknown.
TEST(AlphaSlice, ForgetsWhatLongBranchesAssign) {
  const std::string march = "for (int i = 0; i < 100000; ++i) { t += s; if (t > 3.0) o.r = 0.0; }";
  EXPECT_TRUE(
      of("void main() { float t = 0.0; float a = 1.0; if (s > 0.0) { " + march + " } o.a = a; }").opaque);
  EXPECT_FALSE(
      of("void main() { float t = 0.0; o.a = 1.0; if (s > 0.0) { " + march + " o.a = 0.5; } }").opaque);
}

TEST(AlphaSlice, TakesWhatVerticesGive) {
  const VaryingComponent unknown, one{1.0, {}}, half{0.5, {}}, alpha{{}, {"color", 3}}, red{{}, {"color", 0}};
  const std::string copies = "void main() { o = vec4(n * c.rgb, c.a); }";
  EXPECT_FALSE(of(copies).opaque);
  EXPECT_FALSE(of(copies, {{"c", {one, one, one, unknown}}}).opaque);
  EXPECT_FALSE(of(copies, {{"c", {one, one, one, half}}}).opaque);
  const Opacity constant = of(copies, {{"c", {unknown, unknown, unknown, one}}});
  EXPECT_TRUE(constant.opaque && !constant.exact && constant.ones.empty());
  const Opacity copied =
      of(copies, {{"c", {red, red, red, alpha}}, {"s", {VaryingComponent{{}, {"size", 0}}}}});
  EXPECT_TRUE(copied.opaque && !copied.exact);
  ASSERT_EQ(copied.ones.size(), 1u);
  EXPECT_EQ(copied.ones[0], (AttributeComponent{"color", 3}));
  EXPECT_FALSE(of(copies, {{"c", {red, red, red, red}}}).opaque);
  const Opacity both = of("void main() { o = vec4(n, c.a * s); }",
                          {{"c", {red, red, red, alpha}}, {"s", {VaryingComponent{{}, {"share", 0}}}}});
  EXPECT_TRUE(both.opaque);
  EXPECT_EQ(both.ones.size(), 2u);
  EXPECT_FALSE(of("void main() { o = vec4(n, c.a * s); }", {{"c", {red, red, red, alpha}}}).opaque);
}

TEST(PositionSlice, GivesVaryings) {
  const PositionSlice slice(
      "uniform float half; in vec3 p; in vec4 color; in float size; out vec4 c; out float s, d; varying vec3 "
      "n;\n"
      "void main() { c = color; s = size; d = half * 2.0; n = 2.0 * p; gl_Position = vec4(p, 1.0);"
      " gl_FrontColor = gl_Color; }");
  std::string why;
  Varyings varyings;
  ASSERT_TRUE(slice.evaluate(withUniforms(), why, {}, &varyings)) << why;
  EXPECT_EQ(varyings.at("c")[3].attribute, (AttributeComponent{"color", 3}));
  EXPECT_EQ(varyings.at("s")[0].attribute, (AttributeComponent{"size", 0}));
  EXPECT_EQ(varyings.at("d")[0].value, 1.0);
  EXPECT_EQ(varyings.at("n")[0].attribute, AttributeComponent{});
  EXPECT_EQ(varyings.at("gl_FrontColor")[3].attribute, (AttributeComponent{"gl_Color", 3}));
  EXPECT_EQ(varyings.at("gl_BackColor")[3].attribute, AttributeComponent{});
}

}  // namespace
}  // namespace gluray::gl

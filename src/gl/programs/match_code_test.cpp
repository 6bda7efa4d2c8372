// Whether programs fit a family, judged by the statements of their sources.
#include "gl/glsl/shader_digest.h"
#include "gl/testing/test_match.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::gl {
namespace {

const char* const kCode = R"(match.code = ["one", "two"]
[[code]]
name = "one"
statements = "color = vec4(light0, 1.0);"
[[code]]
name = "two"
statements = "if (color.a < 0.5) discard; gl_Position = m * p;"
)";

TEST_F(Match, ATextureMayHaveAnyName) {
  const FamilyList list = parseFamilies(std::string(kFamily) +
                                            "color.textures = \"t1\"\ncolor.any_texture = \"t1\"\n"
                                            "match.code = \"one\"\n[[code]]\nname = \"one\"\n"
                                            "statements = \"color = texture(t1, p); gl_Position = m * p;\"\n",
                                        "f.toml");
  std::string& fragment = attachBoth();
  const auto found = [&](const Program& p) { return obstacles(real_, p, *list.front(), list.code); };
  Program p = fitting();
  p.uniforms["bricks"].type = GL_SAMPLER_2D;
  fragment = "void main() { color = texture(bricks, p); }";
  EXPECT_EQ(found(p), Lines{});
  fragment = "void main() { color = 2. * texture(bricks, p); }";
  EXPECT_EQ(found(p), Lines{"has the unknown statement \"color=2.*texture(t1,p);\""});
  fragment = "float t1; void main() { color = texture(bricks, p); }";
  EXPECT_EQ(found(p).size(), 2u) << "the text uses the family's name otherwise";

  p.uniforms["t1"].type = GL_SAMPLER_2D;
  EXPECT_EQ(found(p), Lines{"has uniform \"bricks\" (sampler2D), which the family does not describe"});
  p.uniforms.erase("t1"), p.uniforms["wood"].type = GL_SAMPLER_2D;
  EXPECT_EQ(found(p).size(), 2u) << "two candidates";
  p.uniforms.erase("wood"), p.uniforms["bricks"].type = GL_SAMPLER_CUBE;
  EXPECT_EQ(found(p).size(), 1u);
}

TEST_F(Match, StatementsMustBeKnown) {
  const FamilyList list = parseFamilies(std::string(kFamily) + kCode, "f.toml");
  const auto found = [&] { return obstacles(real_, fitting(), *list.front(), list.code); };
  EXPECT_EQ(found(), Lines{"has no source that could be read"});
  std::string& fragment = attachBoth();
  fragment = "uniform vec3 light3; out vec4 color; void main() { color = vec4(light3, 1); }";
  EXPECT_EQ(found(), Lines{"has the unknown statement \"color=vec4(light#,1);\""}) << "1 is not 1.0";
  fragment = "void main() { // all is known\n color = vec4(light3, 1.); if (color.a < .5) discard; }";
  EXPECT_EQ(found(), Lines{});
  fragment += " float f() { return 1.0; }";
  EXPECT_EQ(found(), Lines{"has the unknown statement \"float f(){return 1.;}\""});
  fragment = "void main() { color.r = 1.0; color.r = 1.0; color.g = 2.0; }";
  EXPECT_EQ(found(), (Lines{"has the unknown statement \"color.r=1.;\"",
                            "has the unknown statement \"color.g=2.;\""}));
}

TEST_F(Match, NumbersInStatementsMustBeUsed) {
  const std::string code =
      "match.code = \"one\"\n[[code]]\nname = \"one\"\nstatements = \"color = pow(c, $e); other = $e; "
      "gl_Position = m "
      "* p;\"\n";
  const std::string key = "color.exponent = \"$e\"\n";
  const FamilyList unused = parseFamilies(kFamily + code, "f.toml"),
                   used = parseFamilies(kFamily + key + code, "f.toml");
  std::string& fragment = attachBoth();
  const auto found = [&](const FamilyList& list) {
    return obstacles(real_, fitting(), *list.front(), list.code);
  };
  fragment = "void main() { color = pow(c, 2.2); }";
  EXPECT_EQ(found(used), Lines{});
  EXPECT_EQ(found(unused), Lines{"has a number for \"$e\", which the family does not use"});
  fragment = "void main() { color = pow(c, 2.2); other = 2.4; }";
  EXPECT_EQ(found(used), Lines{"has different numbers for \"$e\""});
}

TEST_F(Match, SlotsMustHaveOneWord) {
  const std::string code =
      "match.code = \"one\"\n[[code]]\nname = \"one\"\n"
      "statements = \"vec4 f() { @blend.a return @blend.b c; } color = f(); gl_Position = m * p;\"\n"
      "[[code.fragments]]\nslot = \"blend\"\nword = \"maximum\"\na = \"c = 1.0;\"\nb = \"2. *\"\n"
      "[[code.fragments]]\nslot = \"blend\"\nword = \"minimum\"\na = \"c = 2.0;\"\n";
  const std::string keys =
      "volume.grid = \"t1\"\nvolume.opacity = \"o\"\nvolume.color = \"k\"\nvolume.texture_from_data = \"m\"\n"
      "volume.step = \"s\"\nvolume.blend = \"@blend\"\n";
  const FamilyList any = parseFamilies(kFamily + code, "f.toml"),
                   chosen = parseFamilies(kFamily + keys + code, "f.toml");
  std::string& fragment = attachBoth();
  const auto found = [&](const FamilyList& list) {
    return obstacles(real_, fitting(), *list.front(), list.code);
  };
  const auto sets = [&](const std::string& a, const std::string& b) {
    fragment = "vec4 f() { " + a + " return " + b + " c; } void main() { color = f(); }";
  };
  const Lines mixed{"has no word whose fragments stand in all slots \"@blend\""},
      none{"has none of the fragments that the family needs in the slots \"@blend\""};
  sets("c = 1.;", "2. *");
  EXPECT_EQ(found(any), Lines{});
  EXPECT_EQ(found(chosen), Lines{});
  sets("c = 2.;", "");
  EXPECT_EQ(found(chosen), Lines{});
  sets("c = 2.;", "2. *");
  EXPECT_EQ(found(any), mixed);
  EXPECT_EQ(found(chosen), mixed);
  sets("", "");
  EXPECT_EQ(found(any), Lines{});
  EXPECT_EQ(found(chosen), none) << "the key has no value without a word";
  fragment = "void main() { color = f(); }";
  EXPECT_EQ(found(chosen), Lines{}) << "no statement has the slot";
}

TEST_F(Match, ShadersMustBeKnownByTheirDigests) {
  std::string& fragment = attachBoth();
  const std::string known = fragment;
  const auto listOf = [](const std::string& digests) {
    return parseFamilies(
        std::string(kFamily) + "match.code = \"c\"\n[[code]]\nname = \"c\"\nshaders = [" + digests + "]\n",
        "f.toml");
  };
  const auto quoted = [](const std::string& text) { return "\"" + textOf(digestOf(text)) + "\""; };
  const FamilyList both = listOf(quoted(g_shaders[0].text) + ", " + quoted(known)),
                   one = listOf(quoted(known));
  const auto found = [&](const FamilyList& list) {
    return obstacles(real_, fitting(), *list.front(), list.code);
  };
  EXPECT_EQ(found(both), Lines{});
  EXPECT_EQ(found(one), Lines{"has an unknown vertex shader, " + textOf(digestOf(g_shaders[0].text))});
  fragment += " // a comment";
  EXPECT_EQ(found(both), Lines{});
  fragment = "void main() { color = vec4(light3, 2.); }";
  EXPECT_EQ(found(both), Lines{"has an unknown fragment shader, " + textOf(digestOf(fragment))});
  fragment = known;
  g_shaders.push_back({GL_FRAGMENT_SHADER, known});
  EXPECT_EQ(found(both), Lines{"has no two shaders that could be read"});
}

TEST_F(Match, BlocksMustBeWhole) {
  const FamilyList list = parseFamilies(
      std::string(kFamily) +
          "match.code = \"one\"\n[[code]]\nname = \"one\"\nblocks = \"c = 1.0; d = c;\"\nwritten = \"v\"\n"
          "statements = \"gl_Position = m * p; color = v; v = p;\"\n",
      "f.toml");
  std::string& fragment = attachBoth();
  const auto found = [&] { return obstacles(real_, fitting(), *list.front(), list.code); };
  fragment = "void main() { c = 1.0; d = c; }";
  EXPECT_EQ(found(), Lines{});
  fragment = "void main() { d = c; color = v; }";
  EXPECT_EQ(found(), (Lines{"has the statement \"d=c;\" twice, or without the rest of its block",
                            "reads \"v\", which it does not write"}));
}

TEST_F(Match, SourcesMustBeComplete) {
  const FamilyList list = parseFamilies(std::string(kFamily) + kCode, "f.toml");
  const auto found = [&] { return obstacles(real_, fitting(), *list.front(), list.code); };
  const Lines unread{"has no source that could be read"};
  const auto without = [&](size_t shader) {
    attachBoth();
    g_shaders.erase(g_shaders.begin() + static_cast<std::ptrdiff_t>(shader));
    return found();
  };
  attachBoth();
  EXPECT_EQ(found(), Lines{});
  EXPECT_EQ(without(0), unread) << "the vertex shader is detached";
  EXPECT_EQ(without(1), unread) << "the fragment shader is detached";
  for (const size_t shader : {0u, 1u}) {
    attachBoth(), g_shaders[shader].hasText = false;
    EXPECT_EQ(found(), unread) << "no source, as after glShaderBinary";
    attachBoth(), g_shaders[shader].text.clear();
    EXPECT_EQ(found(), unread) << "an empty text";
  }
  attachBoth(), g_shaders[0].text = g_shaders[1].text = "void main() {}";
  EXPECT_EQ(found(), unread) << "texts that were replaced after linking";
  attachBoth(), g_shaders.push_back({GL_FRAGMENT_SHADER, "", false});
  EXPECT_EQ(found(), unread) << "a second fragment shader without text";
  attachBoth(), g_shaders.push_back({GL_FRAGMENT_SHADER, "float f() { return 1.0; }"});
  EXPECT_EQ(found(), Lines{"has the unknown statement \"float f(){return 1.;}\""});
  attachBoth(), g_shaders.resize(32, g_shaders[1]);
  EXPECT_EQ(found(), Lines{});
  g_shaders.push_back({GL_FRAGMENT_SHADER, "float f() { return 1.0; }"});
  EXPECT_EQ(found(), unread) << "more shaders than we read";
  attachBoth();
  real_.GetProgramiv = [](GLuint, GLenum, GLint* count) { *count = 3; };
  EXPECT_EQ(found(), unread) << "OpenGL lists fewer shaders than are attached";
}

TEST_F(Match, SourcesOfGeometryShadersMustBeComplete) {
  const FamilyList list =
      parseFamilies(std::string(kFamily) + "match.geometry_shader = true\n" + kCode, "f.toml");
  Program program = fitting();
  program.geometryShader = true;
  const auto found = [&] { return obstacles(real_, program, *list.front(), list.code); };
  attachBoth();
  EXPECT_EQ(found(), Lines{"has no source that could be read"});
  g_shaders.push_back({GL_GEOMETRY_SHADER, "layout(points) in;"});
  EXPECT_EQ(found(), Lines{"has the unknown statement \"layout(points)in;\""});
}

}  // namespace
}  // namespace gluray::gl

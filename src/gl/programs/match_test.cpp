// Which family a program fits, on programs that are nothing but their names.
#include "gl/programs/match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

namespace gluray::gl {
namespace {

using Lines = std::vector<std::string>;
std::map<std::string, GLint> g_outputs;

struct FakeShader {
  GLenum type;
  std::string text;
  bool hasText = true;
};
std::vector<FakeShader> g_shaders;  // those that are attached

/// An OpenGL that knows outputs of fragment shaders and sources alone.
RealGl fakeGl() {
  RealGl real{};
  loadRealGl(
      real, [](void*, const char*) -> void* { return nullptr; }, nullptr);
  real.GetFragDataLocation = [](GLuint, const GLchar* name) {
    const auto it = g_outputs.find(name);
    return it == g_outputs.end() ? -1 : it->second;
  };
  real.GetAttachedShaders = [](GLuint, GLsizei most, GLsizei* count, GLuint* names) {
    *count = std::min(most, static_cast<GLsizei>(g_shaders.size()));
    for (GLsizei i = 0; i < *count; ++i) names[i] = static_cast<GLuint>(i);
  };
  real.GetProgramiv = [](GLuint, GLenum what, GLint* count) {
    *count = what == GL_ATTACHED_SHADERS ? static_cast<GLint>(g_shaders.size()) : 0;
  };
  real.GetShaderiv = [](GLuint name, GLenum what, GLint* value) {
    const FakeShader& shader = g_shaders.at(name);
    const size_t length = shader.hasText ? shader.text.size() + 1 : 0;
    *value = what == GL_SHADER_TYPE ? static_cast<GLint>(shader.type) : static_cast<GLint>(length);
  };
  real.GetShaderSource = [](GLuint shader, GLsizei size, GLsizei* length, GLchar* text) {
    *length = std::min(size - 1, static_cast<GLsizei>(g_shaders.at(shader).text.size()));
    g_shaders.at(shader).text.copy(text, static_cast<size_t>(*length));
    text[*length] = 0;
  };
  return real;
}

Program programOf(std::map<std::string, GLenum> uniforms, std::map<std::string, GLenum> attributes) {
  Program p;
  p.linked = true;
  for (const auto& [name, type] : uniforms) p.uniforms[name].type = type;
  for (const auto& [name, type] : attributes) p.attributes[name].type = type;
  return p;
}

const char* const kFamily = R"([[family]]
name = "f"
match.active = ["p", "m"]
match.absent = ["bad"]
match.absent_outputs = ["second"]
match.ignored = ["time"]
vertex.position = "p"
vertex.normal = "n"
vertex.color = "c"
transform.clip_from_object = "m"
transform.eye_from_object = "v"
transform.normal_matrix = "nm"
color.map = "map"
color.per_triangle = "cells"
material.diffuse_color = "dc"
material.shininess = 7
lights.color = "light{}"
lights.position = "place[{}]"
lights.count = "lights"
)";

class Match : public testing::Test {
 protected:
  Match() { g_outputs = {{"color", 0}}, g_shaders.clear(); }
  Lines obstaclesOf(const Program& program) const { return obstacles(real_, program, *family_); }
  Program fitting() const {
    return programOf({{"m", GL_FLOAT_MAT4}, {"dc", GL_FLOAT_VEC3}, {"light0", GL_FLOAT_VEC3}},
                     {{"p", GL_FLOAT_VEC3}, {"n", GL_FLOAT_VEC3}});
  }
  /// Attaches a vertex and a fragment shader whose statements kCode has; returns the latter's text.
  static std::string& attachBoth() {
    g_shaders = {
        {GL_VERTEX_SHADER, "#version 150\nin vec4 p; uniform mat4 m;\nvoid main() { gl_Position = m*p; }"},
        {GL_FRAGMENT_SHADER, "void main() { color = vec4(light3, 1.); }"}};
    return g_shaders[1].text;
  }
  RealGl real_ = fakeGl();
  std::shared_ptr<const Family> family_ = parseFamilies(kFamily, "f.toml").front();
};

TEST_F(Match, FitsWithLessThanTheFamilyMentions) {
  EXPECT_EQ(obstaclesOf(fitting()), Lines{});
  Program p = fitting();
  p.uniforms["time"].type = GL_FLOAT;
  p.uniforms["light17"].type = GL_FLOAT_VEC3;
  p.uniforms["place"].type = GL_FLOAT_VEC3;
  p.uniforms["map"].type = GL_SAMPLER_2D;
  p.uniforms["nm"].type = GL_FLOAT_MAT3;
  p.attributes["c"].type = GL_FLOAT_VEC4;
  EXPECT_EQ(obstaclesOf(p), Lines{});
}

TEST_F(Match, SaysWhatIsMissing) {
  Program p = fitting();
  p.linked = false;
  EXPECT_EQ(obstaclesOf(p), Lines{"is not linked"});
  p = fitting();
  p.attributes.erase("n");
  EXPECT_EQ(obstaclesOf(p), Lines{"lacks attribute \"n\""});
  p.attributes.erase("p");
  EXPECT_EQ(obstaclesOf(p), (Lines{"lacks \"p\"", "lacks attribute \"p\"", "lacks attribute \"n\""}));
  p = fitting();
  p.uniforms.erase("m");
  EXPECT_EQ(obstaclesOf(p), (Lines{"lacks \"m\"", "lacks uniform \"m\""}));
}

TEST_F(Match, SaysWhatIsTooMuch) {
  Program p = fitting();
  p.uniforms["bad"].type = GL_FLOAT;
  EXPECT_EQ(obstaclesOf(p),
            (Lines{"has \"bad\"", "has uniform \"bad\" (float), of which the family says nothing"}));
  p = fitting();
  p.attributes["bone"].type = GL_FLOAT;
  EXPECT_EQ(obstaclesOf(p), Lines{"has attribute \"bone\" (float), of which the family says nothing"});
  p = fitting();
  p.geometryShader = p.tessellation = p.writes = true;
  EXPECT_EQ(obstaclesOf(p),
            (Lines{"has a geometry shader", "has tessellation shaders", "writes into buffers or images"}));
  g_outputs["second"] = 1;
  EXPECT_EQ(obstaclesOf(fitting()), Lines{"has output \"second\""});
}

TEST_F(Match, TypesMustMeanWhatTheFamilySays) {
  const auto with = [&](const char* name, GLenum type) {
    Program p = fitting();
    p.uniforms[name].type = type;
    return obstaclesOf(p);
  };
  EXPECT_EQ(with("m", GL_FLOAT_MAT3), Lines{"has \"m\", which is not a mat4"});
  EXPECT_EQ(with("m", GL_FLOAT_VEC4), Lines{"has \"m\", which is not a mat4"});
  EXPECT_EQ(with("v", GL_FLOAT_MAT4x3), Lines{"has \"v\", which is not a mat4"});
  EXPECT_EQ(with("nm", GL_FLOAT_VEC3), Lines{"has \"nm\", which is not a mat3 or mat4"});
  EXPECT_EQ(with("dc", GL_FLOAT_MAT3), Lines{"has \"dc\", which is not a number or vector"});
  EXPECT_EQ(with("dc", GL_FLOAT), Lines{});
  EXPECT_EQ(with("map", GL_INT_SAMPLER_2D), Lines{"has \"map\", which is not a sampler"});
  EXPECT_EQ(with("cells", GL_SAMPLER_2D), Lines{"has \"cells\", which is not a samplerBuffer"});
  EXPECT_EQ(with("light0", GL_FLOAT), Lines{"has \"light0\", which is not a vector"});
  EXPECT_EQ(with("place", GL_FLOAT_MAT4), Lines{"has \"place\", which is not a vector"});
  EXPECT_EQ(with("lights", GL_FLOAT_VEC2), Lines{"has \"lights\", which is not a number"});
  EXPECT_EQ(with("time", GL_DOUBLE), Lines{"has \"time\" in double precision"});
  Program p = fitting();
  p.attributes["p"].type = GL_INT_VEC3;
  EXPECT_EQ(obstaclesOf(p), Lines{"has \"p\", which is not a vector"});
}

TEST_F(Match, AlternativesStandForNamesThatAreNotThere) {
  std::string text = kFamily;
  text.replace(text.find("\"p\"\nvertex.normal"), 3, "[\"p\", \"place2\", \"place3\"]");
  text.replace(text.find("= \"map\""), 7, "= [\"map\", \"colors\"]");
  const auto family = parseFamilies(text, "f.toml").front();
  Program p = fitting();
  p.attributes.erase("p"), p.attributes["place3"].type = GL_FLOAT_VEC3;
  p.uniforms["colors"].type = GL_SAMPLER_2D;
  EXPECT_EQ(obstacles(real_, p, *family), Lines{});
  p.renamed = renamedBy(p, *family);
  EXPECT_EQ(p.attribute("p"), &p.attributes.at("place3"));
  EXPECT_EQ(p.uniform("map"), &p.uniforms.at("colors"));
  p.attributes["place2"].type = GL_FLOAT_VEC3;
  EXPECT_EQ(obstacles(real_, p, *family),
            Lines{"has attribute \"place3\" (vec3), of which the family says nothing"})
      << "the first that is there stands for the name, and no other";
  p.attributes["p"].type = GL_FLOAT_VEC3, p.attributes.erase("place2"), p.attributes.erase("place3");
  p.uniforms["colors"].type = GL_FLOAT_MAT4;
  EXPECT_EQ(obstacles(real_, p, *family), Lines{"has \"map\", which is not a sampler"});
}

TEST_F(Match, RecognisedProgramsKeepWhatIsRenamedByTheirFamilyAlone) {
  FamilyList list = parseFamilies(
      "[[family]]\nname = \"far\"\nmatch.active = [\"p\", \"q\"]\nvertex.position = [\"q\", \"n\"]\n"
      "transform.clip_from_object = \"m\"\n",
      "f.toml");
  const Program p = fitting();
  EXPECT_FALSE(renamedBy(p, *list.front()).empty());
  EXPECT_TRUE(renamedBy(p, *family_).empty());
}

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
  EXPECT_EQ(found(p).size(), 2u) << "the family's name means something else";

  p.uniforms["t1"].type = GL_SAMPLER_2D;
  EXPECT_EQ(found(p), Lines{"has uniform \"bricks\" (sampler2D), of which the family says nothing"});
  p.uniforms.erase("t1"), p.uniforms["wood"].type = GL_SAMPLER_2D;
  EXPECT_EQ(found(p).size(), 2u) << "which of them is the one?";
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
  EXPECT_EQ(found(), (Lines{"has the statement \"d=c;\" twice, or without what belongs before and behind it",
                            "reads \"v\", which it does not write"}));
}

TEST_F(Match, SourcesMustBeReadAsAWhole) {
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
    EXPECT_EQ(found(), unread) << "an empty text says nothing of what is computed";
  }
  attachBoth(), g_shaders[0].text = g_shaders[1].text = "void main() {}";
  EXPECT_EQ(found(), unread) << "texts that were given after linking";
  attachBoth(), g_shaders.push_back({GL_FRAGMENT_SHADER, "", false});
  EXPECT_EQ(found(), unread) << "of one of two";
  attachBoth(), g_shaders.push_back({GL_FRAGMENT_SHADER, "float f() { return 1.0; }"});
  EXPECT_EQ(found(), Lines{"has the unknown statement \"float f(){return 1.;}\""});
  attachBoth(), g_shaders.resize(32, g_shaders[1]);
  EXPECT_EQ(found(), Lines{});
  g_shaders.push_back({GL_FRAGMENT_SHADER, "float f() { return 1.0; }"});
  EXPECT_EQ(found(), unread) << "more shaders than are read";
  attachBoth();
  real_.GetProgramiv = [](GLuint, GLenum, GLint* count) { *count = 3; };
  EXPECT_EQ(found(), unread) << "a shader that OpenGL does not name";
}

TEST_F(Match, GeometryShadersMustBeReadToo) {
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

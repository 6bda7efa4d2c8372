// Families of programs that take vertices from fixed function: their files, and which programs fit.
#include "gl/programs/built_in_uniforms.h"
#include "gl/testing/test_family_text.h"
#include "gl/testing/test_match.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::gl {
namespace {

const std::string kBuiltIn =
    "[[code]]\nname = \"c\"\ncomplete = true\nblocks = '''\nn = gl_NormalMatrix * gl_Normal;\n"
    "gl_Position = ftransform();\n\ngl_FragColor = vec4(n, 1.0);\n'''\n"
    "[[family]]\nname = \"f\"\nmatch.active = \"gl_Vertex\"\nmatch.code = \"c\"\n"
    "vertex.position = \"gl_Vertex\"\nvertex.normal = \"gl_Normal\"\n"
    "transform.clip_from_object = \"gl_ModelViewProjectionMatrix\"\n"
    "transform.normal_matrix = \"gl_NormalMatrix\"\n";

std::string mistakeWith(const std::string& more) { return mistake(kBuiltIn + more); }

TEST(BuiltInFamilyFile, Mistakes) {
  EXPECT_EQ(mistakeWith(""), "none");
  EXPECT_EQ(mistakeWith("lights.position = \"gl_LightSource[0].position\"\n"), "none");
  EXPECT_EQ(mistakeWith("lights.position = \"gl_LightSource[9].position\"\n"),
            "x.toml:10: family \"f\": unknown built-in variable gl_LightSource[9].position");
  EXPECT_EQ(mistakeWith("color.textures = \"t\"\n"),
            "x.toml:10: family \"f\": textures of programs with gl_Vertex need vertex.texcoord = "
            "\"gl_MultiTexCoord0\"");
  EXPECT_EQ(mistakeWith("color.textures = \"t\"\nvertex.texcoord = \"gl_MultiTexCoord0\"\n"), "none");
  EXPECT_EQ(
      mistakeWith("color.map = \"t\"\n"),
      "x.toml:10: family \"f\": programs with gl_Vertex have neither impostors nor passes nor colour maps");
  EXPECT_EQ(mistakeWith("vertex.color = \"gl_Color\"\nmaterial.emission_color = 1\n"),
            "x.toml:10: family \"f\": emission_color is for families without vertex.color");
  std::string any = kBuiltIn;
  any.replace(any.find("match.code = \"c\""), 16, "match.code = \"any\"");
  EXPECT_EQ(mistake(any), "x.toml:10: family \"f\": programs with gl_Vertex need match.code");
}

class BuiltInMatch : public Match {
 protected:
  Lines obstaclesWith(const std::string& vertex, const std::string& fragment,
                      std::map<std::string, GLenum> uniforms = {}) {
    const FamilyList list = parseFamilies(kBuiltIn, "x.toml");
    attachBoth() = "void main() {" + fragment + "}";
    g_shaders.front().text = "void main() {" + vertex + "}";
    const Program program =
        programOf(std::move(uniforms), {{"gl_Vertex", GL_FLOAT_VEC4}, {"gl_Normal", GL_FLOAT_VEC3}});
    return obstacles(real_, program, *list.front(), list.code);
  }
  const std::string vertex_ = "n = gl_NormalMatrix * gl_Normal; gl_Position = ftransform();";
};

TEST_F(BuiltInMatch, WholeSectionsFit) {
  EXPECT_EQ(obstaclesWith(vertex_, "gl_FragColor = vec4(n, 1.0);"), Lines{});
}

TEST_F(BuiltInMatch, MissingStatementsDoNot) {
  EXPECT_EQ(obstaclesWith(vertex_, ""), Lines{"lacks statements of the code section \"c\""});
}

TEST_F(BuiltInMatch, OtherStatementsDoNot) {
  EXPECT_EQ(obstaclesWith(vertex_, "gl_FragColor = vec4(n, 1.0); gl_FragColor.x = 1.0;"),
            Lines{"has the unknown statement \"gl_FragColor.x=1.;\""});
}

TEST_F(BuiltInMatch, OtherUniformsDoNot) {
  EXPECT_EQ(obstaclesWith(vertex_, "gl_FragColor = vec4(n, 1.0);", {{"n", GL_FLOAT_VEC3}}),
            Lines{"has uniform \"n\" (vec3), which the family does not describe"});
}

TEST_F(BuiltInMatch, BuiltInUniformsAreStrangersToOtherFamilies) {
  const FamilyList list = parseFamilies(kMin, "x.toml");
  Program program = programOf({{"m", GL_FLOAT_MAT4}}, {{"p", GL_FLOAT_VEC3}});
  program.builtInUniforms["gl_ModelViewMatrix"] = GL_FLOAT_MAT4;
  const Lines found = obstacles(real_, program, *list.front(), list.code);
  EXPECT_NE(std::find(found.begin(), found.end(),
                      "has uniform \"gl_ModelViewMatrix\" (mat4), which the family does not describe"),
            found.end());
}

TEST(BuiltInUniforms, AreNamedForOneFamilyAtATime) {
  const FamilyList list = parseFamilies(kBuiltIn, "x.toml");
  Program program = programOf({{"own", GL_FLOAT}}, {{"gl_Vertex", GL_FLOAT_VEC4}});
  nameBuiltIns(program, *list.front());
  EXPECT_EQ(program.uniforms.size(), 3u);
  EXPECT_EQ(program.uniformElements, 3u);
  ASSERT_TRUE(program.uniform("gl_NormalMatrix"));
  EXPECT_EQ(program.uniform("gl_NormalMatrix")->type, static_cast<GLenum>(GL_FLOAT_MAT3));
  nameBuiltIns(program, parsed());
  EXPECT_EQ(program.uniforms.size(), 1u);
}

}  // namespace
}  // namespace gluray::gl

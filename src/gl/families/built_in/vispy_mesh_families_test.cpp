// The known code of vispy's meshes: shaders of its parts are known, with any transforms; mixed ones are not.
#include "gl/families/family.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace gluray::gl {
namespace {

const std::vector<std::string> kPlain = {"vispy mesh"}, kShaded = {"vispy mesh", "vispy shading"};

class VispyMeshFamilies : public testing::Test {
 protected:
  static std::string vertexShader(const std::string& color, const std::string& more = "",
                                  const std::string& transform = "chain") {
    return "vec4 none(vec4 p) { return p; } uniform vec4 s;"
           "vec4 scale(vec4 p) { return vec4(p.xyz * s.xyz, p.w); }"
           "vec4 chain(vec4 p) { vec4 r = none(p); return scale(r); }"
           "vec4 vec3to4(vec3 xyz) { return vec4(xyz, 1.0); } vec4 pass(vec4 color) { return color; }"
           "void main() { v_base_color = pass(" +
           color + "); gl_Position = " + transform + "(vec3to4(a_position)); " + more + " }";
  }
  static std::string fragmentShader(const std::string& filters) {
    return "void apply_alpha() { gl_FragColor.a = gl_FragColor.a * u_alpha; }"
           "void main() { gl_FragColor = v_base_color; " +
           filters + " }";
  }
  /// The obstacles of a program with these shaders.
  std::vector<std::string> unknown(const std::string& vertex, const std::string& fragment,
                                   const std::vector<std::string>& sections) {
    GlslStatements statements;
    statements.cut(vertex, {}, {.wholeMain = true}), statements.cut(fragment, {}, {.wholeMain = true});
    functions_.clear(), words_.clear();
    if (std::string name = takeFunctions(statements, code(), sections, functions_); !name.empty())
      return {name};
    const auto found = unknownStatements(statements, code(), sections);
    std::vector<std::string> all(found.begin(), found.end());
    if (const std::string group = readWords(statements, code(), sections, words_); !group.empty())
      all.push_back(group);
    return all;
  }
  static const CodeSections& code() { return builtInFamilies().code; }

  FunctionNames functions_;
  SlotWords words_;
};

TEST_F(VispyMeshFamilies, TransformsHaveAnyText) {
  const std::vector<std::string> none;
  EXPECT_EQ(unknown(vertexShader("u_base_color"), fragmentShader("apply_alpha();"), kPlain), none);
  EXPECT_EQ(functions_.at("$clip"), "chain");
  EXPECT_EQ(words_.at("@color"), "uniform");
  EXPECT_EQ(unknown(vertexShader("a_base_color"), fragmentShader(""), kPlain), none);
  EXPECT_EQ(words_.at("@color"), "vertices");
}

TEST_F(VispyMeshFamilies, OtherStatementsAreUnknown) {
  const std::string fragment = fragmentShader("apply_alpha();");
  const auto mains = [&](const std::string& vertex, const std::string& other) {
    return std::ranges::count_if(unknown(vertex, other, kPlain),
                                 [](const std::string& text) { return text.starts_with("void main()"); });
  };
  EXPECT_EQ(mains(vertexShader("u_base_color"), fragment), 0);
  EXPECT_EQ(mains(vertexShader("u_other"), fragment), 1) << "another source of colours";
  EXPECT_EQ(mains(vertexShader("u_base_color", "gl_Position.x += 1.0;"), fragment), 1);
  EXPECT_EQ(mains(vertexShader("u_base_color"), fragmentShader("wireframe(); apply_alpha();")), 1);
  EXPECT_EQ(unknown(vertexShader("u_base_color", "", "absent"), fragment, kPlain),
            std::vector<std::string>{"absent"});
}

TEST_F(VispyMeshFamilies, ShadingIsCompared) {
  const std::string vertex = vertexShader("u_base_color", "prepare_shading();"),
                    fragment = fragmentShader("shade();");
  EXPECT_FALSE(unknown(vertex, fragment, kPlain).empty());
  EXPECT_TRUE(unknown(vertex, fragment, kShaded).empty());
  const auto found = unknown(vertex + " void prepare_shading() {}", fragment + " void shade() {}", kShaded);
  EXPECT_EQ(std::ranges::count(found, "void prepare_shading(){}"), 1);
  EXPECT_EQ(std::ranges::count(found, "void shade(){}"), 1);
}

}  // namespace
}  // namespace gluray::gl

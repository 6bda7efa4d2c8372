// Uniform values by name: shapes of types, array elements, constants in place of uniforms.
#include "gl/programs/uniforms.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::gl {
namespace {

/// A program whose uniforms count up from 1: floats 1, 2, 3 ..., integers 101, 102 ...
class Uniforms : public testing::Test {
 protected:
  void add(const std::string& name, GLenum type, GLint count = 1) {
    program_.uniforms[name] = {0, {}, type, count, values_.size()};
    for (GLint e = 0; e < count; ++e) {
      UniformValue value;
      value.type = type;
      for (size_t i = 0; i < 16; ++i) {
        value.floats[i] = static_cast<float>(i + 1) + 20 * static_cast<float>(e);
        value.integers[i] = static_cast<GLint>(i + 101) + 20 * e;
      }
      values_.push_back(value);
    }
  }
  UniformReader reader() const { return {program_, values_, placeholders_}; }
  Program program_;
  UniformValues values_;
  PlaceholderValues placeholders_;
};

TEST(UniformShapes, OfEveryType) {
  const auto expectShape = [](GLenum type, int columns, int rows, bool integers) {
    const UniformShape s = shapeOf(type);
    EXPECT_EQ(s.columns, columns) << type;
    EXPECT_EQ(s.rows, rows) << type;
    EXPECT_EQ(s.integers, integers) << type;
  };
  const GLenum floats[] = {GL_FLOAT, GL_FLOAT_VEC2, GL_FLOAT_VEC3, GL_FLOAT_VEC4};
  const GLenum ints[] = {GL_INT, GL_INT_VEC2, GL_INT_VEC3, GL_INT_VEC4};
  const GLenum uints[] = {GL_UNSIGNED_INT, GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC3, GL_UNSIGNED_INT_VEC4};
  const GLenum bools[] = {GL_BOOL, GL_BOOL_VEC2, GL_BOOL_VEC3, GL_BOOL_VEC4};
  for (int rows = 1; rows <= 4; ++rows) {
    expectShape(floats[rows - 1], 1, rows, false);
    for (const auto& types : {ints, uints, bools}) expectShape(types[rows - 1], 1, rows, true);
  }
  const GLenum matrices[3][3] = {{GL_FLOAT_MAT2, GL_FLOAT_MAT2x3, GL_FLOAT_MAT2x4},
                                 {GL_FLOAT_MAT3x2, GL_FLOAT_MAT3, GL_FLOAT_MAT3x4},
                                 {GL_FLOAT_MAT4x2, GL_FLOAT_MAT4x3, GL_FLOAT_MAT4}};
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) expectShape(matrices[c][r], c + 2, r + 2, false);
  for (const GLenum sampler : {GL_SAMPLER_2D, GL_SAMPLER_BUFFER, GL_INT_SAMPLER_3D})
    expectShape(sampler, 1, 1, true);
}

TEST_F(Uniforms, ComponentsOfVectors) {
  add("v", GL_FLOAT_VEC3), add("l", GL_FLOAT_VEC4, 2), add("m", GL_FLOAT_MAT4), add("s.r", GL_FLOAT_VEC2);
  EXPECT_EQ(reader().number("v.g"), 2);
  EXPECT_EQ(reader().value({"l[1].b", {}}, glm::vec4(9)), glm::vec4(23)) << "a number for all channels";
  EXPECT_EQ(glm::vec2(reader().vector("s.r")), glm::vec2(1, 2)) << "a member of that name comes first";
  EXPECT_FALSE(reader().has("v.a") || reader().has("m.r") || reader().has("w.r") || reader().has("v.x"));
  EXPECT_EQ(reader().value({"v.a", {}}, glm::vec4(9)), glm::vec4(9));
}

TEST_F(Uniforms, ColumnsOfMatrices) {
  add("m", GL_FLOAT_MAT4), add("n", GL_FLOAT_MAT2x3);
  EXPECT_EQ(reader().vector("m.2"), glm::vec4(9, 10, 11, 12));
  EXPECT_EQ(reader().value({"m.0", {}}, glm::vec4(0)), glm::vec4(1, 2, 3, 4));
  EXPECT_EQ(reader().vector("n.1"), glm::vec4(4, 5, 6, 0));
  EXPECT_EQ(reader().value({"n.1", {}}, glm::vec4(0)), glm::vec4(4, 5, 6, 1));
  EXPECT_FALSE(reader().has("n.2") || reader().has("m.4") || reader().has("m.r"));
}

TEST_F(Uniforms, Products) {
  add("v", GL_FLOAT_VEC4), add("f", GL_FLOAT_VEC2);
  EXPECT_EQ(reader().value({"v", {}, {"f.g", "v"}}, glm::vec4(0)), glm::vec4(2, 8, 18, 32));
  EXPECT_EQ(reader().number({"v.b", {}, {"absent", "v.a"}}, 0), 12) << "others do not count";
  EXPECT_EQ(reader().number({"absent", {}, {"v.a"}}, 0.5f), 2) << "factors count without the first";
}

TEST_F(Uniforms, VectorsAndNumbers) {
  add("v", GL_FLOAT_VEC3), add("i", GL_INT), add("f", GL_FLOAT);
  EXPECT_EQ(glm::vec3(reader().vector("v")), glm::vec3(1, 2, 3));
  EXPECT_EQ(reader().number("f"), 1);
  EXPECT_EQ(reader().integer("i"), 101);
  EXPECT_EQ(reader().integer("f"), 1) << "switches may be floats";
  EXPECT_EQ(reader().vector("i").x, 101);
}

TEST_F(Uniforms, NamesValuesThatAreNotNeutral) {
  add("f", GL_FLOAT), add("v", GL_FLOAT_VEC2), add("i", GL_INT), add("m", GL_FLOAT_MAT2);
  EXPECT_EQ(reader().unlike("f", {1}), "");
  EXPECT_EQ(reader().unlike("f", {2}), "1");
  EXPECT_EQ(reader().unlike("v", {1, 2}), "");
  EXPECT_EQ(reader().unlike("v", {1}), "(1, 2)") << "one number stands for all components";
  EXPECT_EQ(reader().unlike("v", {1, 2, 3}), "(1, 2)");
  EXPECT_EQ(reader().unlike("i", {101}), "");
  EXPECT_EQ(reader().unlike("m", {}), "(1, 2, 3, 4)");
  values_.back().floats = {1, 0, 0, 1};
  EXPECT_EQ(reader().unlike("m", {}), "") << "the identity";
  EXPECT_EQ(reader().unlike("none", {5}), "") << "inactive uniforms have no effect";
}

TEST_F(Uniforms, InactiveUniformsAreZeroOrIdentity) {
  EXPECT_FALSE(reader().has("v"));
  EXPECT_FALSE(reader().has(""));
  EXPECT_EQ(reader().vector("v"), glm::vec4(0));
  EXPECT_EQ(reader().integer(""), 0);
  EXPECT_EQ(reader().matrix4("m"), glm::mat4(1));
  EXPECT_FALSE(reader().product({"m"}));
  EXPECT_FALSE(reader().product({}));
}

TEST_F(Uniforms, ElementsOfArrays) {
  add("before", GL_FLOAT, 2), add("a", GL_FLOAT_VEC2, 3);
  EXPECT_EQ(reader().vector("a", 2).x, 41);
  EXPECT_EQ(reader().vector("a[1]").y, 22);
  EXPECT_TRUE(reader().has("a"));
  EXPECT_TRUE(reader().has("a[2]"));
  EXPECT_FALSE(reader().has("a[3]"));
  EXPECT_FALSE(reader().has("a[]"));
  EXPECT_FALSE(reader().has("a[-1]"));
  EXPECT_FALSE(reader().has("b[0]"));
  EXPECT_EQ(reader().vector("a", 3), glm::vec4(0));
}

TEST_F(Uniforms, MatricesAreExtendedByTheIdentity) {
  add("m3", GL_FLOAT_MAT3), add("m4", GL_FLOAT_MAT4), add("m2x3", GL_FLOAT_MAT2x3), add("v", GL_FLOAT_VEC4);
  EXPECT_EQ(reader().matrix4("m4")[2], glm::vec4(9, 10, 11, 12));
  EXPECT_EQ(reader().matrix4("m3")[1], glm::vec4(4, 5, 6, 0));
  EXPECT_EQ(reader().matrix4("m3")[3], glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(reader().matrix4("m2x3")[1], glm::vec4(4, 5, 6, 0));
  EXPECT_EQ(reader().matrix3("m4")[1], glm::vec3(5, 6, 7));
  EXPECT_EQ(reader().matrix4("v"), glm::mat4(1)) << "no matrix";
  EXPECT_EQ(*reader().product({"m4", "m3"}),
            glm::dmat4(reader().matrix4("m4")) * glm::dmat4(reader().matrix4("m3")));
}

TEST_F(Uniforms, ConstantsAndUniformsAreValues) {
  add("f", GL_FLOAT), add("v", GL_FLOAT_VEC3), add("v2", GL_FLOAT_VEC2), add("i", GL_INT);
  const glm::vec4 otherwise(9);
  const auto value = [&](const FamilyValue& v) { return reader().value(v, otherwise); };
  EXPECT_EQ(value({}), otherwise);
  EXPECT_EQ(value({"gone", {}}), otherwise);
  EXPECT_EQ(value({"f", {}}), glm::vec4(1)) << "a number is all components";
  EXPECT_EQ(value({"i", {}}), glm::vec4(101));
  EXPECT_EQ(value({"v", {}}), glm::vec4(1, 2, 3, 1));
  EXPECT_EQ(value({"", {5}}), glm::vec4(5));
  EXPECT_EQ(value({"", {5, 6, 7}}), glm::vec4(5, 6, 7, 5));
  EXPECT_EQ(value({"", {5, 6, 7, 8}}), glm::vec4(5, 6, 7, 8));
  EXPECT_EQ(reader().number(FamilyValue{"f", {}}, 3.0f), 1);
  EXPECT_EQ(reader().number(FamilyValue{}, 3.0f), 3);
}

TEST_F(Uniforms, ValuesOfPlaceholders) {
  placeholders_["$e"] = 2.2f;
  EXPECT_EQ(reader().value({"$e", {}}, glm::vec4(1)), glm::vec4(2.2f));
  EXPECT_EQ(reader().number(FamilyValue{"$other", {}}, 7.0f), 7);
  EXPECT_FALSE(reader().has("$e"));
}

}  // namespace
}  // namespace gluray::gl

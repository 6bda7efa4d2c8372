// Transforms of many draws found by one run of the shader equal those of a run for each draw, whichever
// uniforms change.
#include "gl/culled/small/placed_positions.h"

#include "gl/glsl/program.h"

#include <GL/glext.h>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gluray::gl {
namespace {

/// Values of uniforms by location, as the real OpenGL of these tests has them.
std::map<GLint, std::vector<float>> g_values;
int g_reads = 0;

void getUniformfv(GLuint, GLint location, GLfloat* values) {
  ++g_reads;
  std::ranges::copy(g_values[location], values);
}
void getUniformiv(GLuint, GLint location, GLint* values) {
  ++g_reads;
  for (const float value : g_values[location]) *values++ = static_cast<GLint>(value);
}

class PlacedPositionsTest : public testing::Test {
 protected:
  PlacedPositionsTest() {
    g_values.clear(), g_reads = 0;
    real_.GetUniformfv = getUniformfv, real_.GetUniformiv = getUniformiv;
    set("P", GL_FLOAT_MAT4, glm::perspective(1.0f, 1.2f, 0.5f, 20.0f));
    set("M", GL_FLOAT_MAT4, glm::mat4(1));
    set("size", GL_FLOAT, std::vector<float>{1});
    set("shift", GL_FLOAT_VEC3, std::vector<float>{0, 0, 0});
    set("rounds", GL_INT, std::vector<float>{1});
  }
  void set(const std::string& name, GLenum type, const std::vector<float>& values) {
    const auto [it, isNew] = program_.uniforms.try_emplace(name);
    if (isNew) it->second.location = static_cast<GLint>(program_.uniforms.size()), it->second.type = type;
    g_values[it->second.location] = values;
  }
  void set(const std::string& name, GLenum type, const glm::mat4& m) {
    set(name, type, std::vector<float>(glm::value_ptr(m), glm::value_ptr(m) + 16));
  }
  CurrentUniforms uniforms() const { return {real_, program_, true}; }

  /// Expects the result of a run of the shader for these values alone. Magnitudes may be larger.
  void expectPlaced(PlacedPositions& positions, const PositionSlice& slice) const {
    PlacedPosition found;
    ASSERT_TRUE(positions.find(uniforms(), found));
    std::string why;
    const std::optional<LinearPosition> alone = slice.evaluate(uniforms(), why);
    ASSERT_TRUE(alone) << why;
    EXPECT_EQ(found.position->attribute, alone->attribute);
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) {
        const double expected = alone->clipFromAttribute[c][r], got = found.matrix.clipFromObject[c][r];
        EXPECT_NEAR(got, expected, 1e-12 * (1 + std::abs(expected))) << c << r;
        EXPECT_GE(found.matrix.magnitudes[c][r], std::abs(got) * (1 - 1e-12)) << c << r;
      }
  }

  RealGl real_{};
  Program program_;
};

constexpr const char* kPlacedAttributes =
    "uniform mat4 P, M; uniform float size; uniform vec3 shift; uniform int rounds;\n"
    "attribute vec3 p;\n";

TEST_F(PlacedPositionsTest, AreThoseOfARunForEachDraw) {
  const PositionSlice slice(std::string(kPlacedAttributes) +
                            "void main() { gl_Position = P * (M * vec4(size * p + shift, 1.0)); }");
  PlacedPositions positions(slice);
  for (int draw = 0; draw < 40; ++draw) {
    const auto d = static_cast<float>(draw);
    set("M", GL_FLOAT_MAT4, glm::rotate(glm::translate(glm::mat4(1), {d, 0, -d}), d, {0, 0.6f, 0.8f}));
    if (draw % 3 == 0) set("size", GL_FLOAT, std::vector<float>{0.5f + d});
    if (draw > 20) set("shift", GL_FLOAT_VEC3, std::vector<float>{d, 1, -d});
    expectPlaced(positions, slice);
    if (HasFailure()) return;
  }
}

/// A matrix that has changed once becomes a symbol. Another value of it then needs no run, which would read
/// all uniforms again.
TEST_F(PlacedPositionsTest, TakeNoRunForAnotherValue) {
  const PositionSlice slice(std::string(kPlacedAttributes) +
                            "void main() { gl_Position = P * (M * vec4(p, 1.0)); }");
  PlacedPositions positions(slice);
  PlacedPosition found;
  const LinearPosition* known = nullptr;
  for (int draw = 0; draw < 30; ++draw) {
    set("M", GL_FLOAT_MAT4, glm::translate(glm::mat4(1), glm::vec3(draw, 2, 3)));
    g_reads = 0;
    ASSERT_TRUE(positions.find(uniforms(), found));
    if (draw < 2) continue;
    EXPECT_EQ(g_reads, 2) << "P is compared, M is put in";
    EXPECT_TRUE(!known || found.position == known);
    known = found.position;
    EXPECT_EQ(glm::dvec3(glm::inverse(glm::dmat4(glm::perspective(1.0f, 1.2f, 0.5f, 20.0f))) *
                         found.matrix.clipFromObject[3])
                  .y,
              2);
  }
}

/// Integers decide branches and loops, and never become symbols.
TEST_F(PlacedPositionsTest, OfOtherBranchesAreOtherRuns) {
  const PositionSlice slice(std::string(kPlacedAttributes) +
                            "void main() { vec4 at = vec4(p, 1.0);\n"
                            "for (int i = 0; i < rounds; ++i) at.xyz += shift;\n"
                            "if (size > 2.0) at.x = -at.x;\n"
                            "gl_Position = P * (M * at); }");
  PlacedPositions positions(slice);
  for (int draw = 0; draw < 60; ++draw) {
    set("rounds", GL_INT, std::vector<float>{static_cast<float>(draw % 3)});
    set("size", GL_FLOAT, std::vector<float>{draw % 5 > 2 ? 3.0f : 1.0f});
    set("shift", GL_FLOAT_VEC3, std::vector<float>{0.1f * static_cast<float>(draw), 1, 0});
    set("M", GL_FLOAT_MAT4, glm::translate(glm::mat4(1), glm::vec3(draw, 0, -9)));
    expectPlaced(positions, slice);
    if (HasFailure()) return;
  }
}

/// Sines of a uniform are known while the uniform is a constant. They never become polynomials.
TEST_F(PlacedPositionsTest, OfFunctionsThatAreNoPolynomials) {
  const PositionSlice slice(std::string(kPlacedAttributes) +
                            "void main() { gl_Position = P * (M * vec4(p * (2.0 + sin(size)), 1.0)); }");
  PlacedPositions positions(slice);
  for (int draw = 0; draw < 60; ++draw) {
    set("size", GL_FLOAT, std::vector<float>{0.1f * static_cast<float>(draw % 4)});
    set("M", GL_FLOAT_MAT4, glm::translate(glm::mat4(1), glm::vec3(0, draw, -9)));
    expectPlaced(positions, slice);
    if (HasFailure()) return;
  }
}

TEST_F(PlacedPositionsTest, AreNotFoundWhereTheyAreNotLinear) {
  const PositionSlice slice(std::string(kPlacedAttributes) +
                            "void main() { gl_Position = P * vec4(size > 2.0 ? sin(p) : p, 1.0); }");
  PlacedPositions positions(slice);
  PlacedPosition found;
  EXPECT_TRUE(positions.find(uniforms(), found));
  set("size", GL_FLOAT, std::vector<float>{3});
  EXPECT_FALSE(positions.find(uniforms(), found));
  set("size", GL_FLOAT, std::vector<float>{1});
  EXPECT_TRUE(positions.find(uniforms(), found));
}

/// If nearly each draw would need a run, the runs cost more than they save.
TEST_F(PlacedPositionsTest, GiveUpWhereRunsAreMany) {
  const PositionSlice slice(std::string(kPlacedAttributes) +
                            "void main() { gl_Position = P * vec4(p * (2.0 + sin(size)), 1.0); }");
  PlacedPositions positions(slice);
  int found = 0;
  for (int draw = 0; draw < 2000; ++draw) {
    set("size", GL_FLOAT, std::vector<float>{0.001f * static_cast<float>(draw)});
    PlacedPosition position;
    found += positions.find(uniforms(), position);
  }
  EXPECT_GT(found, 200);
  EXPECT_LT(found, 700);
}

}  // namespace
}  // namespace gluray::gl

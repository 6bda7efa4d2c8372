// Positions whose matrix depends on instance attributes.
#include "gl/culled/shader_slice/position_slice.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace gluray::gl {
namespace {

glm::dmat4 anyMatrix(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> number(-2, 2);
  glm::dmat4 m;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) m[c][r] = double{number(random)};
  return m;
}

class TwoMatrices final : public UniformSource {
 public:
  bool read(std::string_view name, std::vector<double>& components) const override {
    if (name != "P" && name != "V") return false;
    const glm::dmat4 m = anyMatrix(name == "P" ? 1 : 2);
    components.assign(glm::value_ptr(m), glm::value_ptr(m) + 16);
    return true;
  }
};

/// Values of an instance, by the names of its attributes.
using InstanceNumbers = std::map<std::string, std::vector<double>>;

InstanceNumbers anyNumbers(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> number(-2, 2);
  InstanceNumbers all;
  for (const auto& [name, count] :
       {std::pair{"m", 16}, {"moved", 4}, {"shift", 3}, {"q", 4}, {"rows", 12}, {"size", 1}, {"tint", 3}})
    for (int i = 0; i < count; ++i) all[name].push_back(double{number(random)});
  return all;
}

struct Placed {
  glm::dmat4 matrix, magnitudes;
};

/// The matrix of an instance with these values.
Placed placedBy(const LinearPosition& position, const InstanceNumbers& numbers) {
  std::vector<double> all{1};
  for (const InstanceColumn& column : position.columns)
    for (int r = 0; r < column.rows; ++r)
      all.push_back(numbers.at(column.attribute)[static_cast<size_t>(column.column * column.rows + r)]);
  Placed placed{position.clipFromAttribute, position.magnitudes};
  for (const InstanceColumnTerm& term : position.terms) {
    double product = 1;
    for (int shift = 0; shift < 32; shift += 8) product *= all[(term.product >> shift) & 0xFF];
    placed.matrix[term.column] += product * term.factors;
    placed.magnitudes[term.column] += std::abs(product) * term.magnitudes;
  }
  return placed;
}

const std::string kDeclared =
    "uniform mat4 P, V; in vec3 p; in vec4 q4; in mat4 m; in vec4 moved; in vec3 shift; in vec4 q;\n"
    "in mat3x4 rows; in float size; in vec3 tint; out vec3 c;\n"
    "vec3 turned(vec4 r, vec3 v) { return v + 2.0 * cross(r.xyz, cross(r.xyz, v) + r.w * v); }\n";

const InstanceAttributes kOfInstances{"m", "moved", "shift", "q", "rows", "size", "tint"};

std::optional<LinearPosition> positionBy(const std::string& body, std::string& why) {
  return PositionSlice(kDeclared + "void main() { " + body + " }").evaluate(TwoMatrices(), why, kOfInstances);
}

/// Expects the matrix P * V * expected(values).
void expectPlaced(const std::string& body, glm::dmat4 (*expected)(const InstanceNumbers&)) {
  SCOPED_TRACE(body);
  std::string why;
  const auto position = positionBy(body, why);
  ASSERT_TRUE(position) << why;
  EXPECT_EQ(position->attribute, "p");
  for (unsigned seed = 10; seed < 20; ++seed) {
    const InstanceNumbers numbers = anyNumbers(seed);
    const Placed got = placedBy(*position, numbers);
    const glm::dmat4 wanted = anyMatrix(1) * anyMatrix(2) * expected(numbers);
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) {
        EXPECT_NEAR(got.matrix[c][r], wanted[c][r], 1e-6 * (1 + got.magnitudes[c][r])) << c << r;
        EXPECT_GE(got.magnitudes[c][r], std::abs(wanted[c][r]) * (1 - 1e-9));
      }
  }
}

glm::dvec3 vec3Of(const InstanceNumbers& n, const char* name) { return glm::make_vec3(n.at(name).data()); }

glm::dmat4 movedBy(const InstanceNumbers& n) {
  return glm::scale(glm::translate(glm::dmat4(1), vec3Of(n, "moved")), glm::dvec3(n.at("moved")[3]));
}

TEST(InstanceSlice, FollowsMatrices) {
  const auto matrix = [](const InstanceNumbers& n) { return glm::dmat4(glm::make_mat4(n.at("m").data())); };
  expectPlaced("gl_Position = P * V * (m * vec4(p, 1.0));", matrix);
  expectPlaced("gl_Position = P * V * m * vec4(p, 1.0);", matrix);
  expectPlaced("mat4 all = P * V * m; gl_Position = all * vec4(p, 1.0); c = tint;", matrix);
  expectPlaced("gl_Position = P * V * vec4(vec4(p, 1.0) * rows, 1.0);", [](const InstanceNumbers& n) {
    glm::dmat4 rows(1);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) rows[c][r] = n.at("rows")[static_cast<size_t>(4 * r + c)];
    return rows;
  });
}

TEST(InstanceSlice, FollowsMovesAndSizes) {
  expectPlaced("gl_Position = P * V * vec4(p * moved.w + moved.xyz, 1.0);", movedBy);
  expectPlaced("vec4 e = V * vec4(p * moved.w + moved.xyz, 1.0); gl_Position = P * e;", movedBy);
  expectPlaced("vec3 w = p; w += shift; gl_Position = P * (V * vec4(w, 1.0));",
               [](const InstanceNumbers& n) { return glm::translate(glm::dmat4(1), vec3Of(n, "shift")); });
  expectPlaced("gl_Position = P * V * vec4(shift + size * (p - shift), 1.0);", [](const InstanceNumbers& n) {
    const glm::dmat4 to = glm::translate(glm::dmat4(1), vec3Of(n, "shift"));
    return to * glm::scale(glm::dmat4(1), glm::dvec3(n.at("size")[0])) * glm::inverse(to);
  });
}

TEST(InstanceSlice, FollowsQuaternions) {
  expectPlaced("gl_Position = P * V * vec4(size * turned(q, p) + shift, 1.0);", [](const InstanceNumbers& n) {
    const std::vector<double>& v = n.at("q");
    const glm::dvec3 axis(v[0], v[1], v[2]);
    glm::dmat4 m(1);
    for (int c = 0; c < 3; ++c) {
      glm::dvec3 unit(0);
      unit[c] = 1;
      const glm::dvec3 turned = unit + 2.0 * glm::cross(axis, glm::cross(axis, unit) + v[3] * unit);
      m[c] = glm::dvec4(n.at("size")[0] * turned, 0);
    }
    m[3] = glm::dvec4(vec3Of(n, "shift"), 1);
    return m;
  });
}

TEST(InstanceSlice, LeavesOutWhatPositionsDoNotNeed) {
  std::string why;
  const auto position = positionBy("c = tint * size; gl_Position = P * V * vec4(p, 1.0);", why);
  ASSERT_TRUE(position) << why;
  EXPECT_TRUE(position->terms.empty());
}

TEST(InstanceSlice, RefusesWhatIsNoPolynomial) {
  for (const char* const body :
       {"gl_Position = P * V * vec4(turned(normalize(q), p), 1.0);",
        "gl_Position = P * V * vec4(p + sin(shift), 1.0);", "gl_Position = P * V * vec4(p / size, 1.0);",
        "vec3 w = p; if (size > 0.5) w += shift; gl_Position = P * V * vec4(w, 1.0);",
        "gl_Position = P * V * vec4(p * size * size * size * size * size, 1.0);",
        "gl_Position = P * V * vec4(p * p * size, 1.0);", "gl_Position = P * V * vec4(shift, 1.0);",
        "gl_Position = P * V * (m * q4 + vec4(p, 1.0));",
        "gl_Position = P * V * vec4(p * float(int(size)), 1.0);"}) {
    std::string why;
    EXPECT_FALSE(positionBy(body, why)) << body;
    EXPECT_FALSE(why.empty());
  }
  // An attribute of the vertex, unless it is declared to be one of the instance.
  std::string why;
  const std::string text = kDeclared + "void main() { gl_Position = P * V * vec4(p + shift, 1.0); }";
  EXPECT_FALSE(PositionSlice(text).evaluate(TwoMatrices(), why));
}

}  // namespace
}  // namespace gluray::gl

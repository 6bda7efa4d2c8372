// Visible instances are never skipped, even if a shader rounds; invisible ones mostly are.
#include "gl/culled/instances/instances.h"

#include "gl/testing/test_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace gluray::gl::culling_test {
namespace {

/// Four numbers of each instance: where it is moved to, and its size.
using Moved = std::vector<glm::vec4>;

class NoUniforms final : public UniformSource {
 public:
  glm::mat4 projection{1}, view{1};
  bool read(std::string_view name, std::vector<double>& components) const override {
    const glm::dmat4 m(name == "P" ? projection : view);
    components.assign(&m[0][0], &m[0][0] + 16);
    return name == "P" || name == "V";
  }
};

constexpr const char* kMoved =
    "uniform mat4 P, V; in vec3 p; in vec4 moved;\n"
    "void main() { vec4 eye = V * vec4(p * moved.w + moved.xyz, 1.0); gl_Position = P * eye; }";

ArrayReader readerOf(const Moved& values, GLuint divisor) {
  static const RealGl kNone{};
  ArraySource array;
  array.enabled = true, array.stride = sizeof(glm::vec4), array.divisor = divisor;
  array.pointer = reinterpret_cast<const std::byte*>(values.data());
  return {kNone, array};
}

Instances instancesOf(const Moved& values, const NoUniforms& uniforms, bool fractions = false) {
  std::string why;
  const auto position = PositionSlice(kMoved).evaluate(uniforms, why, {"moved"});
  EXPECT_TRUE(position) << why;
  std::vector<Instances::Column> columns;
  columns.push_back({readerOf(values, 1), 1, 4, fractions});
  return {*position, std::move(columns), InstanceUnits(0, static_cast<uint32_t>(values.size()), {1})};
}

/// The result of a shader in single precision.
glm::dvec4 placed(const NoUniforms& u, const glm::vec4& moved, const glm::vec3& p) {
  const glm::vec4 eye = u.view * glm::vec4(p * moved.w + glm::vec3(moved), 1.0f);
  return glm::dvec4(u.projection * eye);
}

uint64_t shown(const std::vector<uint64_t>& visible) {
  return InstanceUnits(0, 100, {}).instancesIn(visible);
}

Moved swarm(std::mt19937& random, size_t count, float far) {
  std::uniform_real_distribution<float> place(-1, 1), size(0.02f, 0.2f);
  Moved values(count);
  for (glm::vec4& v : values) {
    for (int c = 0; c < 3; ++c) v[c] = place(random);
    v.x += far;
    v.w = size(random);
  }
  return values;
}

TEST(Instances, NeverMissOneThatIsNearerThanTheImage) {
  std::mt19937 random(6);
  uint64_t tested = 0, hidden = 0;
  for (int round = 0; round < 60; ++round) {
    // Far from the origin, single precision moves instances by pixels.
    const float far = round % 3 == 2 ? 2e5f : 0;
    const TestMesh mesh = sheet(8, 8, false, random());
    const Clusters clusters(mesh.primitives());
    const Moved values = swarm(random, 150, far);
    NoUniforms u;
    u.view = glm::mat4(randomView(random) * glm::translate(glm::dmat4(1), glm::dvec3(-double{far}, 0, 0)));
    const Instances instances = instancesOf(values, u);
    const std::vector<float> depths = depthImage(random);
    DepthPyramid pyramid;
    pyramid.build(depths.data(), kWidth, kHeight);
    std::vector<uint64_t> visible;
    instances.mayShow(clusters, window(), &pyramid, visible);
    const Primitives p = mesh.primitives();
    for (uint32_t i = 0; i < 150; ++i) {
      if (isSet(visible, i)) continue;
      ++hidden;
      for (uint32_t t = 0; t < p.count; ++t) {
        std::array<glm::dvec4, 3> clip;
        for (uint32_t c = 0; c < 3; ++c) clip[c] = placed(u, values[i], mesh.points[p.vertex(t, c)]);
        if (std::ranges::any_of(clip, [](const glm::dvec4& corner) { return !(corner.w > 0); })) continue;
        tested += expectBehind(WindowTriangle(clip), depths);
      }
    }
  }
  EXPECT_GT(tested, 20000u);
  EXPECT_GT(hidden, 2000u);
}

TEST(Instances, LeaveOutAllBehindAWall) {
  std::mt19937 random(2);
  const TestMesh mesh = sheet(8, 8, false, 1);
  const Clusters clusters(mesh.primitives());
  const Moved values = swarm(random, 100, 0);
  NoUniforms u;
  u.projection = glm::perspective(1.0f, 1.3f, 0.5f, 20.0f);
  u.view = glm::translate(glm::mat4(1), glm::vec3(0, 0, -5));
  const Instances instances = instancesOf(values, u);
  const std::vector<float> wall(static_cast<size_t>(kWidth) * kHeight, 0.1f), nothing(wall.size(), 1.0f);
  DepthPyramid near, far;
  near.build(wall.data(), kWidth, kHeight), far.build(nothing.data(), kWidth, kHeight);
  std::vector<uint64_t> visible;
  instances.mayShow(clusters, window(), &near, visible);
  EXPECT_EQ(shown(visible), 0u);
  instances.mayShow(clusters, window(), &far, visible);
  EXPECT_GT(shown(visible), 80u);  // some small ones are between the pixels' centres
}

TEST(Instances, AlwaysShowWhereNumbersAreTooLarge) {
  const TestMesh mesh = sheet(8, 8, false, 1);
  const Clusters clusters(mesh.primitives());
  const float none = std::numeric_limits<float>::quiet_NaN();
  const Moved values{{0, 0, 0, 0.1f}, {none, 0, 0, 1}, {0, 0, 1e30f, 1}, {0, 0, 0, 0.1f}};
  const NoUniforms u;
  const Instances instances = instancesOf(values, u);
  DepthPyramid near;
  const std::vector<float> wall(static_cast<size_t>(kWidth) * kHeight, 0.0f);
  near.build(wall.data(), kWidth, kHeight);
  std::vector<uint64_t> visible;
  instances.mayShow(clusters, window(), &near, visible);
  EXPECT_EQ(visible[0], 6u);
  EXPECT_FALSE(instances.matrix(1));
}

/// The lowest signed integer may become -1 or less.
TEST(Instances, AlwaysShowWhereFractionsAreTheLowest) {
  const Moved values{{0, 0, 0, 0.5f}, {0, -1, 0, 0.5f}, {-0.99f, 0, 0, 0.5f}};
  const NoUniforms u;
  const Instances known = instancesOf(values, u), fractions = instancesOf(values, u, true);
  EXPECT_TRUE(known.matrix(1));
  EXPECT_TRUE(fractions.matrix(0));
  EXPECT_FALSE(fractions.matrix(1));
  EXPECT_TRUE(fractions.matrix(2));
}

}  // namespace
}  // namespace gluray::gl::culling_test

// Spheres, tubes and discs in glTF files.
#include "saved/export/arrays/round_shapes.h"
#include "saved/testing/test_export.h"

#include <glm/gtc/matrix_transform.hpp>

namespace gluray::saved {
namespace {

using test::exported;
using test::GlbFile;

/// Spheres of several radii, with a colour each.
scene::Snapshot spheres(const std::vector<glm::vec3>& centers, const std::vector<float>& radii,
                        const std::vector<glm::vec4>& colors) {
  test::MeshData data;
  data.positions = centers, data.colors = colors;
  auto mesh = std::const_pointer_cast<scene::Mesh>(test::makeMesh(data));
  mesh->shape = scene::Shape::spheres, mesh->triangleCount = static_cast<uint32_t>(centers.size());
  mesh->radii = gluray::test::makeAttribute(radii, scene::Format::float1);
  scene::Snapshot s = test::makeSnapshot({mesh});
  s.shadings[0].fragment.model = scene::FragmentShading::Model::phong;
  s.shadings[0].fragment.color = scene::FragmentShading::Color::vertices;
  s.instances[0].impostors.parallelView = true;
  s.instances[0].materials[0].front.diffuse = {1, 1, 1, 1};
  return s;
}

/// The bounds of a node's mesh in world space.
std::pair<glm::vec3, glm::vec3> boundsOf(const GlbFile& file, size_t node) {
  glm::vec3 lower(1e9f), upper(-1e9f);
  const glm::dmat4 m = file.matrixOf(node);
  for (const glm::vec4& p : file.attribute(file.gltf["nodes"][node]["mesh"], "POSITION")) {
    const glm::vec3 world(m * glm::dvec4(glm::dvec3(p), 1));
    lower = glm::min(lower, world), upper = glm::max(upper, world);
  }
  return {lower, upper};
}

/// Whether every triangle of the shape faces outwards, and twice its volume by the divergence theorem.
double outwardVolume(const UnitShape& unit, bool& outwards) {
  double volume = 0;
  for (size_t i = 0; i < unit.indices.size(); i += 3) {
    const glm::dvec3 a(unit.positions[unit.indices[i]]), b(unit.positions[unit.indices[i + 1]]),
        c(unit.positions[unit.indices[i + 2]]);
    const glm::dvec3 n(unit.normals[unit.indices[i]]);
    outwards &= glm::dot(glm::cross(b - a, c - a), n) > 0;
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return volume;
}

TEST(RoundShapes, AreClosedAndFaceOutwards) {
  for (const int quarter : {1, 2, 4, 16}) {
    const UnitShape ball = unitShape(RoundForm::ball, quarter);
    EXPECT_EQ(ball.indices.size(), size_t(3 * 8 * quarter * quarter));
    EXPECT_EQ(ball.positions.size(), size_t(4 * quarter * quarter + 2));
    bool outwards = true;
    const double volume = outwardVolume(ball, outwards);
    EXPECT_TRUE(outwards) << quarter;
    EXPECT_LT(volume, 4.18879);
    EXPECT_GT(volume, quarter == 16 ? 4.15 : 1.3);
    const double tube = outwardVolume(unitShape(RoundForm::closedTube, quarter), outwards);
    EXPECT_TRUE(outwards);
    EXPECT_NEAR(tube, 2 * quarter * std::sin(M_PI / (2 * quarter)), 1e-6) << "of a prism";
  }
}

TEST(GlbImpostors, ASphereHasItsBoundsAndColour) {
  const GlbFile file = exported(spheres({{1, 2, 3}, {-4, 0, 0}}, {0.5f, 2}, {{1, 0, 0, 1}, {0, 0, 1, 1}}));
  const auto nodes = file.meshNodes();
  ASSERT_EQ(nodes.size(), 2u);
  const auto [lower, upper] = boundsOf(file, nodes[0]);
  EXPECT_EQ(lower, glm::vec3(0.5f, 1.5f, 2.5f));
  EXPECT_EQ(upper, glm::vec3(1.5f, 2.5f, 3.5f));
  EXPECT_EQ(boundsOf(file, nodes[1]).first, glm::vec3(-6, -2, -2));
  EXPECT_EQ(file.gltf["meshes"].size(), 2u) << "one a colour";
  EXPECT_EQ(file.gltf["accessors"].size(), 3u) << "of one ball";
  EXPECT_EQ(file.materialOf(0)["pbrMetallicRoughness"]["baseColorFactor"], test::json({1, 0, 0, 1}));
}

TEST(GlbImpostors, ManySpheresAreOneMesh) {
  std::vector<glm::vec3> centers;
  std::vector<glm::vec4> colors;
  for (int i = 0; i < 5000; ++i) {
    centers.emplace_back(i, 0, 0);
    colors.emplace_back(0, static_cast<float>(i % 2), 0, 1);
  }
  scene::Snapshot s = spheres(centers, std::vector<float>(5000, 0.25f), colors);
  const GlbFile file = exported(s);
  const auto nodes = file.meshNodes();
  ASSERT_EQ(nodes.size(), 1u);
  const auto [lower, upper] = boundsOf(file, nodes[0]);
  EXPECT_EQ(lower, glm::vec3(-0.25f)) << "merged balls touch their bounds, too";
  EXPECT_EQ(upper, glm::vec3(4999.25f, 0.25f, 0.25f));
  const auto shown = file.attribute(0, "COLOR_0");
  const size_t each = shown.size() / 5000;
  EXPECT_EQ(shown[0], glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(shown[each], glm::vec4(0, 1, 0, 1));
}

TEST(GlbImpostors, AreRoundInTheProgramsSpace) {
  scene::Snapshot s = spheres({{1, 0, 0}}, {0.5f}, {{1, 1, 1, 1}});
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -7}) * glm::scale(glm::dmat4(1), glm::dvec3(2));
  s.instances[0].eyeFromObject = s.eyeFromWorld;
  s.instances[0].lightingFromObject = glm::mat4(s.eyeFromWorld);
  const auto [lower, upper] = boundsOf(exported(s), 0);
  EXPECT_LT(glm::length(lower - glm::vec3(0.75f, -0.25f, -0.25f)), 1e-6f) << "half as large in the world";
  EXPECT_LT(glm::length(upper - glm::vec3(1.25f, 0.25f, 0.25f)), 1e-6f);
}

TEST(GlbImpostors, ClipPlanesCutThem) {
  scene::Snapshot s = spheres({{0, 0, 0}, {4, 0, 0}}, {1, 1}, {{1, 0, 0, 1}, {1, 0, 0, 1}});
  s.instances[0].clipPlanes = {{-1, 0, 0, 0.25}};
  const GlbFile file = exported(s);
  ASSERT_EQ(file.meshNodes().size(), 1u);
  EXPECT_EQ(boundsOf(file, 0).first, glm::vec3(-1));
  EXPECT_LT(glm::length(boundsOf(file, 0).second - glm::vec3(0.25f, 1, 1)), 1e-6f);
}

TEST(GlbImpostors, SticksHaveTwoColoursAndRoundEnds) {
  scene::Snapshot s = spheres({{0, 0, 0}, {0, 0, 4}}, {0.5f, 0.5f}, {{1, 0, 0, 1}, {0, 0, 1, 1}});
  auto mesh = std::make_shared<scene::Mesh>(*s.instances[0].mesh);
  mesh->shape = scene::Shape::sticks, mesh->triangleCount = 1;
  const uint32_t round = scene::kClosedEnd | scene::kRoundEnd, flat = scene::kClosedEnd;
  mesh->ends =
      gluray::test::makeAttribute<uint32_t>({flat | scene::kTwoHalves, round}, scene::Format::uint32);
  s.instances[0].mesh = mesh;
  const GlbFile halves = exported(s);
  ASSERT_EQ(halves.meshNodes().size(), 3u) << "two halves and a ball";
  EXPECT_LT(glm::length(boundsOf(halves, 0).second - glm::vec3(0.5f, 0.5f, 2)), 1e-6f);
  EXPECT_LT(glm::length(boundsOf(halves, 2).second - glm::vec3(0.5f, 0.5f, 4.5f)), 1e-6f);
  mesh = std::make_shared<scene::Mesh>(*mesh);
  mesh->ends = gluray::test::makeAttribute<uint32_t>({flat, flat}, scene::Format::uint32);
  s.instances[0].mesh = mesh;
  const GlbFile mixed = exported(s);
  ASSERT_EQ(mixed.meshNodes().size(), 1u) << "colours that change along the stick are those of vertices";
  const auto colors = mixed.attribute(0, "COLOR_0");
  EXPECT_EQ(colors.front(), glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(colors.back(), glm::vec4(0, 0, 1, 1));
}

TEST(GlbImpostors, CapsulesAreConesBetweenBalls) {
  scene::Snapshot s = spheres({{0, 0, 0}, {4, 0, 0}}, {1, 1}, {{1, 1, 1, 1}, {1, 1, 1, 1}});
  auto mesh = std::make_shared<scene::Mesh>(*s.instances[0].mesh);
  mesh->shape = scene::Shape::capsules, mesh->triangleCount = 1, mesh->radii = {};
  s.instances[0].mesh = mesh;
  s.instances[0].impostors.radius = 0.5f;
  const GlbFile file = exported(s);
  ASSERT_EQ(file.meshNodes().size(), 3u);
  glm::vec3 lower(9), upper(-9);
  for (size_t node = 0; node < 3; ++node) {
    const auto [a, b] = boundsOf(file, node);
    lower = glm::min(lower, a), upper = glm::max(upper, b);
  }
  EXPECT_LT(glm::length(lower - glm::vec3(-0.5f)), 1e-6f);
  EXPECT_LT(glm::length(upper - glm::vec3(4.5f, 0.5f, 0.5f)), 1e-6f);
}

}  // namespace
}  // namespace gluray::saved

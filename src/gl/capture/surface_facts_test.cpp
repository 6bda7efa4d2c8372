#include "gl/capture/surface_facts.h"

#include "gl/capture/mesh_builder.h"
#include "gl/testing/test_soup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace gluray::gl {
namespace {

using namespace test;

TEST(SurfaceFacts, BoundsAreThoseOfFinitePositions) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> positions;
  for (uint32_t i = 0; i < 1000; ++i) {
    const auto x = static_cast<float>(i);
    const float odd = i % 300 == 299 ? kNan : i % 300 == 298 ? INFINITY : 0;
    positions.insert(positions.end(), {x, -x + odd, 2 * x, kNan, kNan});
  }
  const Bounds bounds = boundsOfFinite(positions.data(), 1000, 5);
  EXPECT_EQ(bounds.lower, glm::vec3(0, -999, 0));
  EXPECT_EQ(bounds.upper, glm::vec3(999, 0, 1998));
  EXPECT_EQ(boundsOfFinite(positions.data() + 5 * 299, 1, 5).lower.x, INFINITY) << "there is none";
}

TEST(SurfaceFacts, DoNotDependOnThePiecesThatCornersComeIn) {
  const CapturedVertices soup = grid(test::kSide, test::kNever);  // several pieces of kIdentityPiece corners
  SurfaceFacts whole;
  SurfaceWatch watch;
  watch.add(soup.vertices.data(), soup.vertexCount, soup.layout.stride);
  ASSERT_TRUE(watch.facts(whole));
  for (const uint32_t step : {1u, 100u, 8192u, 49'152u}) {
    watch.start();
    for (uint32_t first = 0; first < soup.vertexCount; first += step)
      watch.add(soup.vertex(first), std::min(step, soup.vertexCount - first), soup.layout.stride);
    SurfaceFacts facts;
    ASSERT_TRUE(watch.facts(facts));
    EXPECT_EQ(facts.identity, whole.identity) << step;
    EXPECT_EQ(facts.bounds.lower, whole.bounds.lower);
    EXPECT_EQ(facts.bounds.upper, whole.bounds.upper);
    EXPECT_FALSE(watch.facts(facts)) << "taken";
  }
}

class SentFacts : public testing::TestWithParam<Welding> {};
INSTANTIATE_TEST_SUITE_P(Ways, SentFacts, testing::Values(Welding::here, Welding::behind),
                         [](const auto& way) { return way.param == Welding::here ? "here" : "behind"; });

TEST_P(SentFacts, AreThoseOfTheMesh) {
  CapturedVertices welded = grid(test::kSide, test::kWeldFrom, bit(kPosition) | bit(kNormal), GetParam());
  ASSERT_TRUE(welded.facts);
  const KnownMesh known = buildMesh(std::move(welded)), soup = buildMesh(grid(test::kSide, test::kNever));
  EXPECT_EQ(known.mesh->geometryId, soup.mesh->geometryId);
  EXPECT_EQ(known.mesh->lower, soup.mesh->lower);
  EXPECT_EQ(known.mesh->upper, soup.mesh->upper);
}

TEST_P(SentFacts, LeaveOutIncompleteTriangles) {
  for (const bool seen : {false, true}) {
    VertexStream stream;
    stream.start(bit(kPosition), initialSlotValues(), test::kWeldFrom, GetParam());
    stream.begin(GL_TRIANGLES);
    sendGrid(stream, test::kSide);
    for (int i = 0; i < 2; ++i) stream.vertexSlow(-500, static_cast<float>(i), 0, 1);
    if (seen) stream.captured();
    stream.end();
    CapturedVertices welded = stream.takeRun();
    EXPECT_EQ(welded.facts.has_value(), !seen);
    const KnownMesh known = buildMesh(std::move(welded));
    EXPECT_EQ(known.mesh->geometryId,
              buildMesh(grid(test::kSide, test::kNever, bit(kPosition))).mesh->geometryId);
  }
}

TEST_P(SentFacts, AreNoneOnceVerticesGetAnotherForm) {
  VertexStream stream;
  stream.start(bit(kPosition), initialSlotValues(), test::kWeldFrom, GetParam());
  stream.begin(GL_TRIANGLES);
  sendGrid(stream, test::kSide);
  const float normal[] = {0, 0, 1};
  stream.addSlot(kNormal, normal);
  sendGrid(stream, 2);
  stream.end();
  EXPECT_FALSE(stream.takeRun().facts);
}

}  // namespace
}  // namespace gluray::gl

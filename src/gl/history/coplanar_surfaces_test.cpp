#include "gl/history/coplanar_surfaces.h"

#include "gl/testing/test_mesh.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

const glm::dmat4 kView = glm::perspective(0.8, 1.5, 1.0, 20.0) *
                         glm::lookAt(glm::dvec3(3, 2, 6), glm::dvec3(0), glm::dvec3(0, 1, 0));

SurfacePlace here(const glm::dmat4& objectFromObject = glm::dmat4(1)) {
  return {0, {0, 0, 300, 200}, kView * objectFromObject, {}};
}

scene::MeshPtr rectangle(glm::vec2 lower, glm::vec2 upper, float z = 0) {
  const glm::vec3 a(lower, z), b(upper.x, lower.y, z), c(upper, z), d(lower.x, upper.y, z);
  return test::meshOf({a, b, c, a, c, d});
}

TEST(PlanarMeshes, MeetWhereTheyOverlapInOnePlane) {
  CoplanarSurfaces planar;
  EXPECT_FALSE(planar.meets(rectangle({-1, -1}, {1, 1}), here()));
  EXPECT_FALSE(planar.meets(rectangle({1, -1}, {2, 1}), here())) << "a neighbour";
  EXPECT_FALSE(planar.meets(rectangle({-1, -1}, {1, 1}, 0.01f), here())) << "in front";
  EXPECT_FALSE(planar.takeFound());
  EXPECT_TRUE(planar.meets(rectangle({-0.5f, -0.5f}, {0.2f, 3}), here()));
  EXPECT_TRUE(planar.takeFound());
  EXPECT_FALSE(planar.takeFound());
}

TEST(PlanarMeshes, MeetAcrossMatrices) {
  CoplanarSurfaces planar;
  const glm::dmat4 turned =
      glm::translate(glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(0, 0, 1)), {0.1, 0.2, 0.5});
  EXPECT_FALSE(planar.meets(rectangle({-1, -1}, {1, 1}, 0.5f), here()));
  EXPECT_TRUE(planar.meets(rectangle({-1, -1}, {1, 1}), here(turned)));
  EXPECT_FALSE(planar.meets(rectangle({-1, -1}, {1, 1}, 1), here(turned)));
}

TEST(PlanarMeshes, EqualTrianglesDoNotCount) {
  CoplanarSurfaces planar;
  const scene::MeshPtr all = rectangle({-1, -1}, {1, 1});
  EXPECT_FALSE(planar.meets(all, here()));
  EXPECT_FALSE(planar.meets(all, here()));
  EXPECT_FALSE(planar.meets(test::meshOf({{1, 1, 0}, {-1, -1, 0}, {1, -1, 0}}), here()));
  EXPECT_TRUE(planar.meets(test::meshOf({{1, 1, 0}, {-1, -1, 0}, {0.9f, -1, 0}}), here()));
}

TEST(PlanarMeshes, DoNotMeetAcrossOffsetsViewportsOrFramebuffers) {
  const scene::MeshPtr first = rectangle({-1, -1}, {1, 1}), second = rectangle({-0.5f, -0.5f}, {0.2f, 3});
  SurfacePlace pushed = here(), otherWindow = here(), otherViewport = here();
  pushed.offset.units = 2;
  otherWindow.framebuffer = 7;
  otherViewport.viewport.x = 300;
  for (const SurfacePlace& place : {pushed, otherWindow, otherViewport}) {
    CoplanarSurfaces planar;
    EXPECT_FALSE(planar.meets(first, here()));
    EXPECT_FALSE(planar.meets(second, place));
  }
}

TEST(PlanarMeshes, AreRememberedForAHundredDepthEpochs) {
  CoplanarSurfaces planar;
  const scene::MeshPtr first = rectangle({-1, -1}, {1, 1}), second = rectangle({-0.5f, -0.5f}, {0.2f, 3});
  planar.meets(first, here()), planar.meets(second, here());
  EXPECT_TRUE(planar.takeFound());
  planar.clear();
  EXPECT_TRUE(planar.meets(first, here()));
  EXPECT_TRUE(planar.meets(second, here()));
  EXPECT_FALSE(planar.takeFound()) << "nothing waits to be traced";
  for (int epoch = 0; epoch < 101; ++epoch) {
    planar.clear();
    EXPECT_EQ(planar.meets(first, here()), epoch < 100) << epoch;
  }
}

TEST(PlanarMeshes, StayUntilTheirPixelsAreCleared) {
  const scene::MeshPtr first = rectangle({-1, -1}, {1, 1}), second = rectangle({-0.5f, -0.5f}, {0.2f, 3});
  const scene::Region all{0, 0, 10000, 10000}, corner{0, 0, 40, 40};
  const auto meetsAfter = [&](const auto& between) {
    CoplanarSurfaces planar;
    EXPECT_FALSE(planar.meets(first, here()));
    between(planar);
    return planar.meets(second, here());
  };
  EXPECT_TRUE(meetsAfter([&](CoplanarSurfaces& planar) { planar.clear({7, all}); })) << "another framebuffer";
  EXPECT_TRUE(meetsAfter([&](CoplanarSurfaces& planar) { planar.clear({0, corner}); }));
  EXPECT_TRUE(meetsAfter([](CoplanarSurfaces& planar) { planar.shown(); }));
  EXPECT_FALSE(meetsAfter([&](CoplanarSurfaces& planar) { planar.clear({0, all}); }));
  EXPECT_FALSE(meetsAfter([](CoplanarSurfaces& planar) { planar.clear(); }));
}

TEST(PlanarMeshes, OfEarlierEpochsMakeRoom) {
  CoplanarSurfaces planar;
  for (size_t i = 0; i < CoplanarSurfaces::kMaxPlanarMeshes; ++i)
    planar.meets(rectangle({-1, -1}, {1, 1}, 0.002f * static_cast<float>(i)), here());
  EXPECT_FALSE(planar.meets(rectangle({-0.5f, -0.5f}, {0.2f, 3}), here())) << "no room";
  planar.shown();
  EXPECT_FALSE(planar.meets(rectangle({-1, -1}, {1, 1}), here()));
  EXPECT_TRUE(planar.meets(rectangle({-0.5f, -0.5f}, {0.2f, 3}), here()));
}

TEST(DepthHistory, OtherFramebuffersCountUntilThisOneIsCleared) {
  DepthHistory history;
  const DepthStamp drawn = history.stamp({1, {0, 0, 10, 10}});
  EXPECT_TRUE(history.reaches(drawn, 1));
  EXPECT_TRUE(history.reaches(drawn, 2)) << "they may share their depth";
  history.clear({2, {0, 0, 10, 10}});
  EXPECT_FALSE(history.reaches(drawn, 2));
  EXPECT_TRUE(history.reaches(drawn, 1));
  EXPECT_TRUE(history.reaches(history.stamp({1, {0, 0, 10, 10}}), 2)) << "drawn later";
}

TEST(DepthHistory, ForgetsWhatIsNeverCleared) {
  DepthHistory history;
  const DepthStamp drawn = history.stamp({1, {0, 0, 10, 10}});
  for (uint64_t i = 0; i < DepthHistory::kMaxTurns; ++i) history.nextTurn();
  EXPECT_FALSE(history.isOld(drawn));
  history.nextTurn();
  EXPECT_TRUE(history.isOld(drawn));
}

TEST(DepthClear, RemovesWhatItCovers) {
  const DepthClear clear{0, {0, 0, 100, 50}};
  EXPECT_TRUE(clear.removes({0, {0, 0, 100, 50}}));
  EXPECT_TRUE(clear.removes({0, {-20, -10, 120, 60}})) << "no pixels have negative coordinates";
  EXPECT_FALSE(clear.removes({1, {0, 0, 100, 50}}));
  EXPECT_FALSE(clear.removes({0, {0, 0, 101, 50}}));
}

TEST(PlanarMeshes, BentSurfacesAreNotPlanar) {
  CoplanarSurfaces planar;
  const std::vector<glm::vec3> bent = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0},
                                       {-1, -1, 0}, {1, 1, 0},  {-1, 1, 0.01f}};
  EXPECT_FALSE(planar.meets(test::meshOf(bent), here()));
  EXPECT_FALSE(planar.meets(rectangle({-1, -1}, {1, 1}), here()));
}

/// One square tile of a map: 8x8 pairs of triangles, at lattice position `at`.
scene::MeshPtr tile(glm::ivec2 at, double turned) {
  const glm::dmat4 mapFromTiles = glm::rotate(glm::dmat4(1), turned, glm::dvec3(0, 0, 1));
  std::vector<glm::vec3> corners;
  const auto add = [&](int x, int y) {
    corners.emplace_back(mapFromTiles * glm::dvec4(0.025 * (8 * at.x + x), 0.025 * (8 * at.y + y), 0, 1));
  };
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      add(x, y), add(x + 1, y), add(x + 1, y + 1), add(x, y), add(x + 1, y + 1), add(x, y + 1);
  return test::meshOf(corners);
}

/// Draws 20x20 tiles, placed by their vertices or, if `ownMatrices`, by matrices as with glTranslatef.
void drawTiles(CoplanarSurfaces& planar, double turned, bool ownMatrices) {
  const glm::mat4 mapFromTiles(glm::rotate(glm::dmat4(1), turned, glm::dvec3(0, 0, 1)));
  for (int y = -10; y < 10; ++y) {
    for (int x = -10; x < 10; ++x) {
      const glm::vec3 by = 0.2f * glm::vec3(glm::ivec3(x, y, 0));
      const glm::dmat4 moved(glm::translate(mapFromTiles, by));
      EXPECT_FALSE(ownMatrices ? planar.meets(tile({0, 0}, 0), here(moved))
                               : planar.meets(tile({x, y}, turned), here()))
          << x << ' ' << y;
    }
  }
}

TEST(PlanarMeshes, TilesOfATiltedMapAreDistinguishedByFewTriangles) {
  // The bounds of about 1,600 pairs of tiles overlap in the window: 26 million pairs of triangles.
  for (const bool ownMatrices : {false, true}) {
    for (const double turned : {0.0, 0.7}) {
      CoplanarSurfaces planar;
      drawTiles(planar, turned, ownMatrices);
      // Bounds along the map's axes separate the tiles; bounds of rotated vertices do not.
      const bool byBounds = ownMatrices || turned == 0;
      EXPECT_LE(planar.work(), byBounds ? 0u : 700'000u) << ownMatrices << ' ' << turned;
      EXPECT_TRUE(planar.meets(rectangle({-0.5f, -0.5f}, {0.2f, 0.3f}), here()))
          << "a rectangle upon the tiles";
    }
  }
}

TEST(PlanarMeshes, BoundsDecideBeyondTheWorkLimit) {
  // Two interleaved combs: the sweep along x cannot separate their long triangles.
  const auto comb = [](float from) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 2000; ++i) {
      const float y = from + static_cast<float>(i) * 1e-3f - 1;
      corners.insert(corners.end(), {{-1, y, 0}, {1, y, 0}, {1, y + 4e-4f, 0}});
    }
    return test::meshOf(corners);
  };
  CoplanarSurfaces planar;
  EXPECT_FALSE(planar.meets(comb(0), here()));
  EXPECT_TRUE(planar.meets(comb(5e-4f), here()));
  EXPECT_LT(planar.work(), CoplanarSurfaces::kMaxWork + 50000);
  planar.clear();
  EXPECT_EQ(planar.work(), 0u);
}

TEST(PlanarMeshes, BoundsDecideBehindTheViewer) {
  CoplanarSurfaces planar;
  EXPECT_FALSE(planar.meets(rectangle({-100, -100}, {100, 100}), here()));
  EXPECT_TRUE(planar.meets(rectangle({-0.5f, -0.5f}, {0.2f, 3}), here()));
}

}  // namespace
}  // namespace gluray::gl

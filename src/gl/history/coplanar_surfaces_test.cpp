#include "gl/history/coplanar_surfaces.h"

#include "gl/state/state.h"
#include "gl/testing/test_mesh.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

const glm::dmat4 kView = glm::perspective(0.8, 1.5, 1.0, 20.0) *
                         glm::lookAt(glm::dvec3(3, 2, 6), glm::dvec3(0), glm::dvec3(0, 1, 0));

/// Without a scissor test.
DepthPlace placeOf(uint32_t framebuffer, const glm::ivec4& viewport) {
  ViewportState state;
  state.box = viewport;
  return {framebuffer, viewport, state.region()};
}

SurfacePlace here(const glm::dmat4& objectFromObject = glm::dmat4(1)) {
  return {placeOf(0, {0, 0, 300, 200}), kView * objectFromObject, {}};
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
  otherWindow.at = placeOf(7, {0, 0, 300, 200});
  otherViewport.at = placeOf(0, {300, 0, 300, 200});
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

TEST(PlanarMeshes, MeetOnlyInPixelsThatBothMayCover) {
  const scene::MeshPtr first = rectangle({-1, -1}, {1, 1}), second = rectangle({-0.5f, -0.5f}, {0.2f, 3});
  const auto scissored = [](const scene::Region& to) {
    SurfacePlace place = here();
    place.at.region = to;
    return place;
  };
  const SurfacePlace left = scissored({0, 0, 150, 200}), right = scissored({150, 0, 150, 200});
  const auto meet = [&](const SurfacePlace& a, const SurfacePlace& b) {
    CoplanarSurfaces planar;
    EXPECT_FALSE(planar.meets(first, a));
    return planar.meets(second, b);
  };
  EXPECT_TRUE(meet(left, left));
  EXPECT_TRUE(meet(left, here()));
  EXPECT_FALSE(meet(left, right));
  CoplanarSurfaces planar;
  EXPECT_FALSE(planar.meets(first, here()));
  planar.clear({0, left.at.region});
  EXPECT_FALSE(planar.meets(second, left)) << "drawn again where all was cleared";
  EXPECT_TRUE(planar.meets(second, here()));
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

constexpr glm::ivec4 kTen(0, 0, 10, 10);

TEST(DepthHistory, OtherFramebuffersCountUntilThisOneIsCleared) {
  DepthHistory history;
  const DepthStamp drawn = history.stamp(placeOf(1, kTen));
  EXPECT_TRUE(history.reaches(drawn, placeOf(1, kTen)));
  EXPECT_TRUE(history.reaches(drawn, placeOf(2, kTen))) << "they may share their depth";
  history.clear({2, {0, 0, 10, 10}});
  EXPECT_FALSE(history.reaches(drawn, placeOf(2, kTen)));
  EXPECT_TRUE(history.reaches(drawn, placeOf(1, kTen)));
  EXPECT_TRUE(history.reaches(history.stamp(placeOf(1, kTen)), placeOf(2, kTen))) << "drawn later";
}

TEST(DepthHistory, PartsThatWereClearedHoldNothing) {
  DepthHistory history;
  const auto at = [](const scene::Region& region) { return DepthPlace{1, kTen, region}; };
  const scene::Region left{0, 0, 5, 10}, right{5, 0, 5, 10}, within{1, 1, 2, 2};
  const DepthStamp drawn = history.stamp(placeOf(1, kTen)), drawnRight = history.stamp(at(right));
  EXPECT_TRUE(history.reaches(drawn, at(left)));
  EXPECT_FALSE(history.reaches(drawnRight, at(left))) << "other pixels";
  history.clear({1, left});
  const DepthStamp again = history.stamp(at(left));
  EXPECT_FALSE(history.reaches(drawn, at(left)));
  EXPECT_FALSE(history.reaches(drawn, at(within)));
  EXPECT_TRUE(history.reaches(drawn, at(right)));
  EXPECT_TRUE(history.reaches(drawn, placeOf(1, kTen)));
  EXPECT_TRUE(history.reaches(again, at(within)));
  history.clear({1, within});
  EXPECT_FALSE(history.reaches(again, at(within)));
  EXPECT_FALSE(history.reaches(drawn, at(left))) << "the larger clear still counts";
}

TEST(DepthHistory, KnowsOnlyTheLastClears) {
  DepthHistory history;
  const DepthStamp drawn = history.stamp(placeOf(1, {0, 0, 1000, 10}));
  const auto pixel = [](int x) { return DepthPlace{1, kTen, {x, 0, 1, 1}}; };
  for (int x = 0; x < 100; ++x) history.clear({1, pixel(x).region});
  EXPECT_FALSE(history.reaches(drawn, pixel(99)));
  EXPECT_TRUE(history.reaches(drawn, pixel(0)));
}

TEST(DepthHistory, ForgetsWhatIsNeverCleared) {
  DepthHistory history;
  const DepthStamp drawn = history.stamp(placeOf(1, kTen));
  for (uint64_t i = 0; i < DepthHistory::kMaxTurns; ++i) history.nextTurn();
  EXPECT_FALSE(history.isOld(drawn));
  history.nextTurn();
  EXPECT_TRUE(history.isOld(drawn));
}

TEST(DepthClear, RemovesWhatItCovers) {
  const DepthClear clear{0, {0, 0, 100, 50}};
  EXPECT_TRUE(clear.removes(placeOf(0, {0, 0, 100, 50})));
  EXPECT_TRUE(clear.removes(placeOf(0, {-20, -10, 120, 60}))) << "no pixels have negative coordinates";
  EXPECT_FALSE(clear.removes(placeOf(1, {0, 0, 100, 50})));
  EXPECT_FALSE(clear.removes(placeOf(0, {0, 0, 101, 50})));
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

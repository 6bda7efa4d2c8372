#include "gl/sheets.h"

#include "gl/test_mesh.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

const glm::dmat4 kView = glm::perspective(0.8, 1.5, 1.0, 20.0) *
                         glm::lookAt(glm::dvec3(3, 2, 6), glm::dvec3(0), glm::dvec3(0, 1, 0));

SheetPlace here(const glm::dmat4& objectFromObject = glm::dmat4(1)) {
  return {0, {0, 0, 300, 200}, kView * objectFromObject, {}};
}

scene::MeshPtr rectangle(glm::vec2 lower, glm::vec2 upper, float z = 0) {
  const glm::vec3 a(lower, z), b(upper.x, lower.y, z), c(upper, z), d(lower.x, upper.y, z);
  return test::meshOf({a, b, c, a, c, d});
}

TEST(Sheets, MeetWhereTheyOverlapInOnePlane) {
  Sheets sheets;
  EXPECT_FALSE(sheets.meets(rectangle({-1, -1}, {1, 1}), here()));
  EXPECT_FALSE(sheets.meets(rectangle({1, -1}, {2, 1}), here())) << "a neighbour";
  EXPECT_FALSE(sheets.meets(rectangle({-1, -1}, {1, 1}, 0.01f), here())) << "in front";
  EXPECT_FALSE(sheets.takeFound());
  EXPECT_TRUE(sheets.meets(rectangle({-0.5f, -0.5f}, {0.2f, 3}), here()));
  EXPECT_TRUE(sheets.takeFound());
  EXPECT_FALSE(sheets.takeFound());
}

TEST(Sheets, MeetAcrossMatrices) {
  Sheets sheets;
  const glm::dmat4 turned =
      glm::translate(glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(0, 0, 1)), {0.1, 0.2, 0.5});
  EXPECT_FALSE(sheets.meets(rectangle({-1, -1}, {1, 1}, 0.5f), here()));
  EXPECT_TRUE(sheets.meets(rectangle({-1, -1}, {1, 1}), here(turned)));
  EXPECT_FALSE(sheets.meets(rectangle({-1, -1}, {1, 1}, 1), here(turned)));
}

TEST(Sheets, TrianglesThatAreEqualDoNotCount) {
  Sheets sheets;
  const scene::MeshPtr all = rectangle({-1, -1}, {1, 1});
  EXPECT_FALSE(sheets.meets(all, here()));
  EXPECT_FALSE(sheets.meets(all, here()));
  EXPECT_FALSE(sheets.meets(test::meshOf({{1, 1, 0}, {-1, -1, 0}, {1, -1, 0}}), here()));
  EXPECT_TRUE(sheets.meets(test::meshOf({{1, 1, 0}, {-1, -1, 0}, {0.9f, -1, 0}}), here()));
}

TEST(Sheets, OffsetsViewportsAndFramebuffersKeepThemApart) {
  const scene::MeshPtr first = rectangle({-1, -1}, {1, 1}), second = rectangle({-0.5f, -0.5f}, {0.2f, 3});
  SheetPlace pushed = here(), otherWindow = here(), otherViewport = here();
  pushed.offset.units = 2;
  otherWindow.framebuffer = 7;
  otherViewport.viewport.x = 300;
  for (const SheetPlace& place : {pushed, otherWindow, otherViewport}) {
    Sheets sheets;
    EXPECT_FALSE(sheets.meets(first, here()));
    EXPECT_FALSE(sheets.meets(second, place));
  }
}

TEST(Sheets, AreKnownForAHundredLayers) {
  Sheets sheets;
  const scene::MeshPtr first = rectangle({-1, -1}, {1, 1}), second = rectangle({-0.5f, -0.5f}, {0.2f, 3});
  sheets.meets(first, here()), sheets.meets(second, here());
  EXPECT_TRUE(sheets.takeFound());
  sheets.clear();
  EXPECT_TRUE(sheets.meets(first, here()));
  EXPECT_TRUE(sheets.meets(second, here()));
  EXPECT_FALSE(sheets.takeFound()) << "nothing waits to be traced";
  for (int layer = 0; layer < 101; ++layer) {
    sheets.clear();
    EXPECT_EQ(sheets.meets(first, here()), layer < 100) << layer;
  }
}

TEST(Sheets, SurfacesThatAreNotFlatAreNone) {
  Sheets sheets;
  const std::vector<glm::vec3> bent = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0},
                                       {-1, -1, 0}, {1, 1, 0},  {-1, 1, 0.01f}};
  EXPECT_FALSE(sheets.meets(test::meshOf(bent), here()));
  EXPECT_FALSE(sheets.meets(rectangle({-1, -1}, {1, 1}), here()));
}

TEST(Sheets, ThatReachBehindTheViewerMeetByTheirBounds) {
  Sheets sheets;
  EXPECT_FALSE(sheets.meets(rectangle({-100, -100}, {100, 100}), here()));
  EXPECT_TRUE(sheets.meets(rectangle({-0.5f, -0.5f}, {0.2f, 3}), here()));
}

}  // namespace
}  // namespace gluray::gl

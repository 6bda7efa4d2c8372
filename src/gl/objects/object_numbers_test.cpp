// Surfaces keep their numbers across frames.
#include "gl/objects/object_numbers.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <memory>
#include <set>

namespace gluray::gl {
namespace {

/// A surface of the program: its geometry, position and colour.
struct Thing {
  uint64_t geometry = 1;
  double x = 0;
  float red = 1;
  uint32_t triangles = 10;
};
using Things = std::vector<Thing>;
using SurfaceNumbers = std::vector<uint32_t>;

class ObjectNumbersTest : public testing::Test {
 protected:
  static BatchKey keyOf(GLuint framebuffer, glm::ivec4 viewport = {0, 0, 100, 100}) {
    BatchKey key;
    key.framebuffer = framebuffer, key.viewport = viewport;
    return key;
  }
  /// The numbers of a batch's surfaces, drawn with the camera `camera_`.
  SurfaceNumbers draw(const Things& things, const BatchKey& key = keyOf(0)) {
    scene::Snapshot s;
    s.camera.clipFromEye = projection_;
    s.eyeFromWorld = camera_;
    for (const Thing& thing : things) {
      auto mesh = std::make_shared<scene::Mesh>();
      mesh->geometryId = {thing.geometry, 0};
      mesh->triangleCount = thing.triangles;
      scene::Instance& instance = s.instances.emplace_back();
      instance.mesh = mesh;
      instance.worldFromObject[3][0] = static_cast<float>(thing.x - things.front().x);  // as in batches
      instance.eyeFromObject = camera_ * glm::translate(glm::dmat4(1), {thing.x, 0, 0});
      instance.materials.resize(1);
      instance.materials[0].front.diffuse.r = thing.red;
    }
    numbers_.number(key, s);
    SurfaceNumbers found;
    for (const scene::Instance& instance : s.instances) found.push_back(instance.object.value);
    return found;
  }
  SurfaceNumbers frame(const Things& things) {
    numbers_.beginFrame();
    return draw(things);
  }
  static size_t different(const SurfaceNumbers& numbers) {
    return std::set<uint32_t>(numbers.begin(), numbers.end()).size();
  }

  ObjectNumbers numbers_;
  glm::dmat4 camera_{1}, projection_ = glm::perspective(1.0, 1.0, 0.1, 100.0);
};

TEST_F(ObjectNumbersTest, EachSurfaceHasItsOwn) {
  const SurfaceNumbers first = frame({{1}, {2}, {3}});
  EXPECT_EQ(different(first), 3u);
  EXPECT_FALSE(std::count(first.begin(), first.end(), 0u));
}

TEST_F(ObjectNumbersTest, StaysWhenTheCameraTheColorsOrTheOrderChange) {
  const SurfaceNumbers first = frame({{1}, {2}, {3}});
  camera_ = glm::rotate(glm::translate(glm::dmat4(1), {0, 0, -5}), 0.7, {0, 1, 0});
  EXPECT_EQ(frame({{1}, {2}, {3}}), first);
  EXPECT_EQ(frame({{1, 0, 0.2f}, {2, 0, 0.3f}, {3, 0, 0.4f}}), first);
  EXPECT_EQ(frame({{3}, {1}, {2}}), (SurfaceNumbers{first[2], first[0], first[1]}));
}

TEST_F(ObjectNumbersTest, StaysWhenTheObjectMoves) {
  const SurfaceNumbers first = frame({{1}, {2}});
  EXPECT_EQ(frame({{1, 4}, {2}}), first);
}

TEST_F(ObjectNumbersTest, StaysInANewTimeStep) {
  const SurfaceNumbers first = frame({{1, 0, 1}, {2, 0, 0.5f}, {3, 0, 0.2f}});
  EXPECT_EQ(frame({{11, 0, 1}, {12, 0, 0.5f}, {13, 0, 0.2f}}), first) << "all shapes are new";
  EXPECT_EQ(frame({{11, 0, 1}, {22, 0, 0.5f}, {13, 0, 0.2f}}), first) << "one between known ones";
}

TEST_F(ObjectNumbersTest, StaysInATimeStepThatHasOneMoreObject) {
  const SurfaceNumbers first = frame({{1, 0, 1}, {2, 0, 0.5f}});
  const SurfaceNumbers second = frame({{11, 0, 1}, {99, 0, 0.1f}, {12, 0, 0.5f}});
  EXPECT_EQ(second[0], first[0]);
  EXPECT_EQ(second[2], first[1]);
  EXPECT_EQ(different({first[0], first[1], second[1]}), 3u);
}

TEST_F(ObjectNumbersTest, ComesBackWithAnObjectThatWasLeftOut) {
  const SurfaceNumbers first = frame({{1}, {2}, {3}});
  EXPECT_EQ(frame({{1}, {3}}), (SurfaceNumbers{first[0], first[2]}));
  EXPECT_EQ(frame({{1}, {3}}), (SurfaceNumbers{first[0], first[2]}));
  EXPECT_EQ(frame({{1}, {2}, {3}}), first);
}

TEST_F(ObjectNumbersTest, EqualGeometryIsToldApartByItsPlace) {
  const SurfaceNumbers first = frame({{1, 1}, {1, 2}, {1, 3}});
  EXPECT_EQ(different(first), 3u);
  EXPECT_EQ(frame({{1, 1}, {1, 3}}), (SurfaceNumbers{first[0], first[2]}));
  EXPECT_EQ(frame({{1, 1}, {1, 2}, {1, 3}}), first);
  EXPECT_EQ(frame({{1, 5}, {1, 6}, {1, 8}}), first) << "all have moved: their order";
}

TEST_F(ObjectNumbersTest, EqualSurfacesKeepTheirNumbersWithoutTheFirst) {
  const SurfaceNumbers first = frame({{1, 1}, {1, 2}, {1, 3}});
  EXPECT_EQ(frame({{1, 2}, {1, 3}}), (SurfaceNumbers{first[1], first[2]}));
  EXPECT_EQ(frame({{1, 1}, {1, 2}, {1, 3}}), first);
  camera_ = glm::translate(glm::dmat4(1), {1, 0, 0});  // by their distance
  EXPECT_EQ(frame({{1, 1}, {1, 2}, {1, 3}}), first);
}

TEST_F(ObjectNumbersTest, EqualSurfacesComeBackInTheirOrder) {
  const SurfaceNumbers first = frame({{1, 1}, {1, 2}, {1, 3}, {7}});
  frame({{7}});
  frame({{7}});
  EXPECT_EQ(frame({{1, 1}, {1, 2}, {1, 3}, {7}}), first);
}

TEST_F(ObjectNumbersTest, ASurfaceThatIsDrawnTwiceIsOneObject) {
  const SurfaceNumbers first = frame({{1}, {1}, {2}});
  EXPECT_EQ(first[0], first[1]);
  EXPECT_EQ(frame({{1}, {1}, {2}}), first);
  EXPECT_EQ(frame({{1}, {1}, {2}}), first);
}

TEST_F(ObjectNumbersTest, FurtherPassesDrawTheSameObjects) {
  const SurfaceNumbers first = frame({{1}, {2}});
  EXPECT_EQ(draw({{2}, {1}}), (SurfaceNumbers{first[1], first[0]}));
  EXPECT_EQ(draw({{1}}, keyOf(7)), (SurfaceNumbers{first[0]})) << "in a framebuffer of their own";
  EXPECT_EQ(frame({{1}, {2}}), first);
}

TEST_F(ObjectNumbersTest, BatchesOfATimeStepAreComparedWithTheirOwn) {
  const SurfaceNumbers opaque = frame({{1}, {2}}), translucent = draw({{3}});
  EXPECT_EQ(frame({{11}, {12}}), opaque);
  EXPECT_EQ(draw({{13}}), translucent);
  const SurfaceNumbers fewer = frame({{21}});
  EXPECT_TRUE(fewer[0] == opaque[0] || fewer[0] == opaque[1]);
  EXPECT_EQ(draw({{23}}), translucent) << "the rest of the first batch is not taken by the second";
}

TEST_F(ObjectNumbersTest, ViewsHaveObjectsOfTheirOwn) {
  const BatchKey left = keyOf(0, {0, 0, 50, 100}), right = keyOf(0, {50, 0, 50, 100});
  numbers_.beginFrame();
  const SurfaceNumbers one = draw({{1}}, left), two = draw({{1}}, right);
  EXPECT_NE(one, two);
  numbers_.beginFrame();
  EXPECT_EQ(draw({{1}}, right), two);
  EXPECT_EQ(draw({{1}}, left), one);
}

TEST_F(ObjectNumbersTest, StaysWhenTheWindowGetsAnotherSizeAndFramebuffer) {
  const SurfaceNumbers first = frame({{1}, {2}});
  numbers_.beginFrame();
  EXPECT_EQ(draw({{1}, {2}}, keyOf(9, {0, 0, 300, 200})), first);
}

TEST(ObjectMatchingTest, OtherShapesAreOtherObjects) {
  const ObjectTraits triangles{{1, 0}, scene::Shape::triangles, 5, 0},
      spheres{{2, 0}, scene::Shape::spheres, 5, 0};
  EXPECT_EQ(likeness(triangles, spheres), 0);
  EXPECT_EQ(alignObjects({&triangles}, {&spheres}), std::vector<size_t>{kNoObject});
}

TEST(ObjectMatchingTest, LongListsAreComparedOneByOne) {
  const ObjectTraits one{{1, 0}, scene::Shape::triangles, 5, 0}, tubes{{2, 0}, scene::Shape::tubes, 5, 0};
  std::vector<const ObjectTraits*> before(2000, &one);
  const std::vector<const ObjectTraits*> now(1000, &one);
  before[0] = &tubes;
  const std::vector<size_t> found = alignObjects(before, now);
  EXPECT_EQ(found[0], kNoObject);
  for (size_t i = 1; i < found.size(); ++i) ASSERT_EQ(found[i], i);
}

TEST(ObjectMatchingTest, EquallyManyKeepTheirOrderOnlyIfAllCanBeTheSame) {
  const ObjectTraits triangles{{1, 0}, scene::Shape::triangles, 5, 0},
      tubes{{2, 0}, scene::Shape::tubes, 5, 0};
  EXPECT_EQ(alignObjects({&triangles, &triangles}, {&triangles, &triangles}), (std::vector<size_t>{0, 1}));
  const std::vector<size_t> found = alignObjects({&triangles, &tubes}, {&tubes, &triangles});
  EXPECT_TRUE(found == (std::vector<size_t>{1, kNoObject}) || found == (std::vector<size_t>{kNoObject, 0}));
}

}  // namespace
}  // namespace gluray::gl

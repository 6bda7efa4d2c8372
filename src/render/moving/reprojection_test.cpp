// Where earlier frames saw points, and what has moved.
#include "render/moving/reprojection.h"

#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::render {
namespace {

constexpr int kReprojectedSize = 64;

scene::Snapshot twoSquares(const glm::dmat4& clipFromEye) {
  scene::Snapshot s = test::makeSnapshot(
      {test::makeMesh(test::squareData()), test::makeMesh(test::squareData(0.5f))}, kReprojectedSize);
  s.camera.clipFromEye = clipFromEye;
  return s;
}

void look(scene::Snapshot& s, const glm::dmat4& eyeFromWorld) {
  s.eyeFromWorld = eyeFromWorld;
  for (scene::Instance& i : s.instances) i.eyeFromObject = eyeFromWorld * glm::dmat4(i.worldFromObject);
}

/// A frame's data, without pixels.
struct Prepared {
  Arena arena{1};
  accel::World world;
  Image image;
  scene::Snapshot snapshot;
  std::unique_ptr<FrameData> frame;
  PixelSpace space;
  Placement placement;

  explicit Prepared(const scene::Snapshot& s) : snapshot(s) {
    world.update(snapshot, arena);
    image.resize(kReprojectedSize, kReprojectedSize, 1);
    frame = std::make_unique<FrameData>(snapshot, world, image);
    space = PixelSpace(*frame);
    placement.rememberScene(snapshot);
  }
  Reprojection since(const Prepared& earlier) const {
    return {earlier.placement, earlier.space, placement, *frame};
  }
};

const glm::dmat4 kPerspective = glm::perspective(glm::radians(40.0), 1.0, 0.5, 20.0);
const glm::dmat4 kParallel = glm::ortho(-2.0, 2.0, -2.0, 2.0, 0.5, 20.0);
const glm::dmat4 kAway = glm::translate(glm::dmat4(1), {0, 0, -5});

glm::dvec2 pixelAt(const glm::dmat4& pixelFromEye, const glm::dvec3& p) {
  const glm::dvec4 clip = pixelFromEye * glm::dvec4(p, 1);
  return glm::dvec2(clip) / clip.w;
}

TEST(PixelSpace, PixelsAndDepthsGiveThePointsThatTheyShow) {
  for (const glm::dmat4& projection : {kPerspective, kParallel, glm::scale(kPerspective, {-1, 1, 1})}) {
    scene::Snapshot s = twoSquares(projection);
    s.region = {3, 5, kReprojectedSize - 3, kReprojectedSize - 5};
    look(s, kAway);
    const Prepared p(s);
    ASSERT_TRUE(p.space.usable);
    for (const glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(50, 7), glm::dvec2(31.5, 20.25)})
      for (const float depth : {0.9f, 1.0f, 1.5f}) {
        const auto x = static_cast<float>(pixel.x), y = static_cast<float>(pixel.y);
        const glm::vec3 base = p.space.base + x * p.space.baseX + y * p.space.baseY,
                        ray = p.space.ray + x * p.space.rayX + y * p.space.rayY, point = base + depth * ray;
        EXPECT_NEAR(glm::dot(p.space.depth, glm::vec4(point, 1)), depth, 1e-5f);
        EXPECT_LT(glm::length(pixelAt(p.space.pixelFromEye, point) - pixel), 1e-3);
      }
  }
}

TEST(PixelSpace, PixelsAreAsWideAsTheyAre) {
  scene::Snapshot s = twoSquares(kParallel);
  look(s, kAway);
  const Prepared p(s);
  EXPECT_NEAR(p.space.pixel + 1.3f * p.space.perDepth, 4.0f / kReprojectedSize, 1e-6f);
}

TEST(Reprojection, OfAStillCameraIsTheIdentity) {
  scene::Snapshot s = twoSquares(kPerspective);
  look(s, kAway);
  const Prepared a(s), b(s);
  const Reprojection r = b.since(a);
  EXPECT_FALSE(r.changed);
  EXPECT_EQ(r.earlierFromEye, glm::mat4(1));
}

TEST(Reprojection, FollowsTheCamera) {
  for (const glm::dmat4& projection : {kPerspective, kParallel}) {
    scene::Snapshot s = twoSquares(projection);
    look(s, kAway);
    const Prepared before(s);
    look(s, glm::rotate(glm::translate(kAway, {0.3, -0.1, 0.4}), 0.2, {0.3, 1, 0.1}));
    const Prepared now(s);
    const Reprojection r = now.since(before);
    EXPECT_FALSE(r.changed);
    for (const glm::dvec4 world : {glm::dvec4(0, 0, 0, 1), glm::dvec4(-0.7, 0.4, 0.5, 1)}) {
      const glm::dvec3 eye(s.eyeFromWorld * world), earlier(kAway * world);
      EXPECT_LT(glm::length(glm::dvec3(r.earlierFromEye * glm::vec4(eye, 1)) - earlier), 1e-5);
      EXPECT_LT(glm::length(pixelAt(glm::dmat4(r.earlierPixelFromEye), eye) -
                            pixelAt(before.space.pixelFromEye, earlier)),
                1e-3);
    }
  }
}

TEST(Reprojection, KnowsWhatHasMoved) {
  scene::Snapshot s = twoSquares(kPerspective);
  look(s, kAway);
  const Prepared before(s);
  s.instances[1].worldFromObject[3].x = 0.2f;
  look(s, glm::rotate(kAway, 0.1, {0, 1, 0}));
  const Reprojection r = Prepared(s).since(before);
  EXPECT_TRUE(r.changed);
  EXPECT_TRUE(r.stayed(0));
  EXPECT_FALSE(r.stayed(1));
}

TEST(Reprojection, KnowsNewAndChangedMeshes) {
  scene::Snapshot s = twoSquares(kPerspective);
  look(s, kAway);
  const Prepared before(s);
  s.instances.push_back(s.instances[1]);
  const Reprojection more = Prepared(s).since(before);
  EXPECT_TRUE(more.changed && more.stayed(1));
  EXPECT_FALSE(more.stayed(2));
  s.instances.pop_back();
  s.instances[0].mesh = test::makeMesh(test::squareData(0.01f));
  const Reprojection other = Prepared(s).since(before);
  EXPECT_TRUE(other.changed && other.stayed(1));
  EXPECT_FALSE(other.stayed(0));
  s.instances.resize(1);
  EXPECT_TRUE(Prepared(s).since(before).changed);
}

TEST(Reprojection, ClipPlanesMoveWithTheWorld) {
  scene::Snapshot s = twoSquares(kPerspective);
  look(s, kAway);
  const glm::dvec4 plane(1, 0, 0, 0.3);  // world space
  s.instances[1].clipPlanes = {plane * glm::inverse(s.eyeFromWorld)};
  const Prepared before(s);
  look(s, glm::rotate(kAway, 0.3, {0, 1, 0}));
  s.instances[1].clipPlanes = {plane * glm::inverse(s.eyeFromWorld)};
  EXPECT_FALSE(Prepared(s).since(before).changed);
  s.instances[1].clipPlanes = {glm::dvec4(1, 0, 0, 0.4) * glm::inverse(s.eyeFromWorld)};
  EXPECT_TRUE(Prepared(s).since(before).changed);
}

}  // namespace
}  // namespace gluray::render

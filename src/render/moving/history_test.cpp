// History of narrow round surfaces on buffers made by hand.
#include "render/moving/history.inl.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace gluray::render {
namespace {

constexpr int kTubesSize = 32;  // pixels
constexpr float kTubeRadius = 1.2f;
constexpr float kTubeX[] = {10, 12.4f};  // axes along y; the tubes touch

/// A view along -z whose pixels are one unit wide; a depth of 1 + d is at z = -100 d.
PixelSpace unitPixels() {
  PixelSpace space;
  space.usable = true;
  space.base = {0, 0, 100}, space.ray = {0, 0, -100};
  space.baseX = {1, 0, 0}, space.baseY = {0, 1, 0};
  space.depth = {0, 0, -0.01f, 1}, space.pixel = 1;
  return space;
}

/// The tube at x, and the normal there; -1: none.
int tubeAt(float x, glm::vec3& normal) {
  for (int tube = 0; tube < 2; ++tube) {
    const float aside = (x - kTubeX[tube]) / kTubeRadius;
    if (std::abs(aside) > 0.98f) continue;
    normal = {aside, 0, std::sqrt(1 - aside * aside)};
    return tube;
  }
  return -1;
}
glm::vec3 pointOn(int tube, const glm::vec3& normal, float y) {
  return glm::vec3(kTubeX[tube], y, -50) + kTubeRadius * normal;
}

}  // namespace

namespace HWY_NAMESPACE {

/// The visibility of the first tube is 1, that of the second 0; 16 samples each.
void fillTubes(VisibilityBuffer& buffer, const PixelSpace& space) {
  buffer.resize(kTubesSize, kTubesSize, 1);
  buffer.clear(0, 0, kTubesSize, kTubesSize);
  for (int y = 0; y < kTubesSize; ++y)
    for (int x = 0; x < kTubesSize; ++x) {
      glm::vec3 normal;
      const int tube = tubeAt(static_cast<float>(x), normal);
      if (tube < 0) continue;
      const glm::vec3 point = pointOn(tube, normal, static_cast<float>(y));
      const float depth = glm::dot(glm::vec3(space.depth), point) + space.depth.w;
      const VisibilityPixels packed{splat(depth), splat(16), splat(tube == 0 ? 1.0f : 0.0f), splat(0),
                                    splat(normal)};
      uint32_t* words = buffer.words.data() + 2 * static_cast<size_t>(y * kTubesSize + x);
      words[0] = hn::GetLane(packed.word0()), words[1] = hn::GetLane(packed.word1());
    }
}

/// What is known of the point of a tube, seen aside of where points of it were.
Known knownAt(const MovingFrame& moving, int tube, const glm::vec3& n, bool narrow) {
  alignas(64) Row point[3], normal[3];
  NarrowLanes lanes;
  const glm::vec3 p = pointOn(tube, n, 8.3f);
  for (int i = 0; i < kLanes; ++i) {
    for (int c = 0; c < 3; ++c)
      point[c][i] = p[c], normal[c][i] = n[c], lanes.axis[c][i] = c == 1 ? 1.0f : 0.0f;
    lanes.center[0][i] = kTubeX[tube], lanes.center[1][i] = 8.3f, lanes.center[2][i] = -50;
    lanes.radius[i] = kTubeRadius;
  }
  lanes.any = narrow;
  Known known;
  lookUp(moving, point, normal, lanes, known);
  return known;
}

TEST(History, OfNarrowTubesIsFoundAndStaysOnThem) {
  VisibilityBuffer buffer;
  MovingFrame moving;
  moving.earlierSpace = moving.space = unitPixels();
  fillTubes(buffer, moving.space);
  moving.earlier = &buffer, moving.mostSamples = 16, moving.channels.used.occlusion = true;
  int found = 0, withoutAxes = 0, count = 0;
  for (float x = 8.9f; x < 13.6f; x += 0.1f) {
    glm::vec3 normal;
    const int tube = tubeAt(x, normal);
    if (tube < 0) continue;
    const Known known = knownAt(moving, tube, normal, true);
    ++count, found += known.samples[0] > 0;
    withoutAxes += knownAt(moving, tube, normal, false).samples[0] > 0;
    if (known.samples[0] == 0) continue;
    EXPECT_EQ(known.visibility.occlusion[0], tube == 0 ? 1.0f : 0.0f) << x;
    EXPECT_NEAR(known.samples[0], 16, 1e-3f) << x;
  }
  EXPECT_EQ(found, count) << "of points on both tubes";
  EXPECT_LT(withoutAxes, count) << "planes and normals find the points of fewer";
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render

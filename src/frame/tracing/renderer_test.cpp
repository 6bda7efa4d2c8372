#include "frame/tracing/renderer.h"

#include "accel/device/device.h"
#include "accel/testing/test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace gluray {
namespace {

using test::makeMesh;
using test::makeSnapshot;

struct Rendered {
  Image image;
  scene::TraceCost statistics;
  std::string error;
  bool ok = false;
  float depth(int x, int y) const { return image.depth[static_cast<size_t>(y * image.width + x)]; }
  uint32_t color(int x, int y) const { return image.color[static_cast<size_t>(y * image.width + x)]; }
};

Rendered render(frame::Renderer& renderer, const scene::Snapshot& snapshot) {
  Rendered r;
  r.ok = renderer.render(snapshot, r.image, r.statistics, r.error);
  return r;
}

TEST(Renderer, TriangleCoversItsPixels) {
  frame::Renderer renderer;
  test::MeshData data;
  data.positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}};  // the lower left half of the window
  auto snapshot = makeSnapshot({makeMesh(data)});
  snapshot.instances[0].color = {1, 0.5f, 0, 1};
  const Rendered r = render(renderer, snapshot);
  ASSERT_TRUE(r.ok) << r.error;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      if (x + y == 15) continue;  // pixel centres exactly on the edge
      const bool inside = x + y < 15;
      EXPECT_EQ(r.color(x, y), inside ? 0xFF0080FFu : 0u) << x << ' ' << y;
      EXPECT_FLOAT_EQ(r.depth(x, y), inside ? 0.5f : Image::kMiss);
    }
  }
}

TEST(Renderer, EmptySceneIsAllMisses) {
  frame::Renderer renderer;
  for (const auto& snapshot : {makeSnapshot({}), makeSnapshot({makeMesh({})})}) {
    const Rendered r = render(renderer, snapshot);
    ASSERT_TRUE(r.ok) << r.error;
    ASSERT_EQ(r.image.depth.size(), 256u);
    EXPECT_EQ(std::count(r.image.depth.begin(), r.image.depth.end(), Image::kMiss), 256);
    EXPECT_EQ(std::count(r.image.color.begin(), r.image.color.end(), 0u), 256);
  }
}

TEST(Renderer, MissesHaveTheRequestedColour) {
  frame::Renderer renderer;
  test::MeshData data;
  data.positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}};  // the lower left half of the window
  for (const auto& snapshot : {makeSnapshot({makeMesh(data)}), makeSnapshot({})}) {
    Image image;
    image.missColor = 0x12345678;
    scene::TraceCost statistics;
    std::string error;
    ASSERT_TRUE(renderer.render(snapshot, image, statistics, error)) << error;
    for (size_t i = 0; i < image.color.size(); ++i) {
      if (image.depth[i] != Image::kMiss) continue;
      ASSERT_EQ(image.color[i], 0x12345678u) << i;
    }
    EXPECT_EQ(image.color[255], 0x12345678u);
  }
}

TEST(Renderer, NullRendererMissesEverything) {
  frame::Renderer renderer;
  auto snapshot = makeSnapshot({makeMesh(test::squareData())});
  snapshot.settings.renderer = gluray::Renderer::null;
  const Rendered r = render(renderer, snapshot);
  ASSERT_TRUE(r.ok);
  EXPECT_EQ(std::count(r.image.depth.begin(), r.image.depth.end(), Image::kMiss), 256);
  EXPECT_EQ(r.statistics.blasBuilds, 0u);
}

TEST(Renderer, OnlyGeometryRebuildsStructures) {
  frame::Renderer renderer;
  test::MeshData data = test::squareData();
  auto snapshot = makeSnapshot({makeMesh(data)});
  Rendered r = render(renderer, snapshot);
  EXPECT_EQ(r.statistics.blasBuilds, 1u);
  EXPECT_GT(r.statistics.bvhBytes, 0u);

  snapshot.eyeFromWorld[3][0] = snapshot.instances[0].eyeFromObject[3][0] = 0.25;  // camera
  snapshot.camera.clipFromEye[0][0] = 2;
  snapshot.shadings[0].lighting = true;  // lights
  snapshot.shadings[0].lights.resize(2);
  snapshot.instances[0].materials[0].front.diffuse = {1, 0, 0, 1};
  data.colors.assign(4, {0, 1, 0, 1});  // colours
  snapshot.instances[0].mesh = makeMesh(data);
  r = render(renderer, snapshot);
  EXPECT_EQ(r.statistics.blasBuilds + r.statistics.tlasBuilds, 0u);

  data.positions[2].z = 0.5f;
  snapshot.instances[0].mesh = makeMesh(data);
  EXPECT_EQ(render(renderer, snapshot).statistics.blasBuilds, 1u);
}

TEST(Renderer, SharedGeometryKeepsEachMeshsAttributes) {
  frame::Renderer renderer;
  test::MeshData red = test::squareData(), green = test::squareData();
  red.colors.assign(4, {1, 0, 0, 1});
  green.colors.assign(4, {0, 1, 0, 1});
  EXPECT_EQ(render(renderer, makeSnapshot({makeMesh(red)})).color(8, 8), 0xFF0000FFu);
  const Rendered r = render(renderer, makeSnapshot({makeMesh(green)}));
  EXPECT_EQ(r.color(8, 8), 0xFF00FF00u);
  EXPECT_EQ(r.statistics.blasBuilds, 0u);
}

TEST(Renderer, AFailedBuildIsReportedAndTheNextFrameWorks) {
  frame::Renderer renderer;
  const auto snapshot = makeSnapshot({makeMesh(test::squareData())});
  accel::failNextCommits(1);
  const Rendered failed = render(renderer, snapshot);
  EXPECT_FALSE(failed.ok);
  EXPECT_EQ(failed.error, "the acceleration structure of a mesh cannot be built: out of memory");
  const Rendered r = render(renderer, snapshot);
  EXPECT_TRUE(r.ok) << r.error;
  EXPECT_FLOAT_EQ(r.depth(8, 8), 0.5f);
}

TEST(Renderer, InvalidSnapshotsAreRefused) {
  frame::Renderer renderer;
  const auto refused = [&](const auto& edit) {
    auto snapshot = makeSnapshot({makeMesh(test::squareData())});
    edit(snapshot);
    const Rendered r = render(renderer, snapshot);
    return r.ok ? std::string("rendered") : r.error;
  };
  using scene::Snapshot;
  EXPECT_EQ(refused([](Snapshot& s) { s.camera.clipFromEye = glm::dmat4(0); }),
            "the projection matrix cannot be inverted");
  EXPECT_EQ(refused([](Snapshot& s) { s.eyeFromWorld[1][1] = std::nan(""); }),
            "the modelview matrix cannot be inverted");
  EXPECT_EQ(refused([](Snapshot& s) { s.region.width = 0; }), "the region to trace is empty");
  EXPECT_EQ(refused([](Snapshot& s) { s.region.height = 1 << 30; }),
            "the region to trace is larger than any framebuffer");
  EXPECT_EQ(refused([](Snapshot& s) { s.camera.viewport.z = 0; }), "the viewport has no area");
  EXPECT_EQ(refused([](Snapshot& s) { s.samples = 4; }),
            "the number of sample positions is not the number of samples");
  EXPECT_EQ(refused([](Snapshot&) {}), "rendered");
}

TEST(Renderer, SmallRegionOfAHugeViewport) {
  frame::Renderer renderer;
  auto snapshot = makeSnapshot({makeMesh(test::squareData())});
  snapshot.camera.viewport = {-30000, -30000, 60000, 60000};
  snapshot.region = {5, 7, 3, 2};
  const Rendered r = render(renderer, snapshot);
  ASSERT_TRUE(r.ok) << r.error;
  EXPECT_EQ(r.image.x, 5);
  EXPECT_EQ(r.image.y, 7);
  ASSERT_EQ(r.image.depth.size(), 6u);
  for (const float depth : r.image.depth) EXPECT_FLOAT_EQ(depth, 0.5f);
}

TEST(Renderer, ThreadsTakeTurns) {
  frame::Renderer renderer;
  const auto snapshot = makeSnapshot({makeMesh(test::squareData())});
  auto other = snapshot;
  other.settings.threads = 1;
  const Image expected = render(renderer, snapshot).image;
  std::vector<std::thread> threads;
  std::atomic<int> equal{0};
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      for (int frame = 0; frame < 10; ++frame) {
        const Rendered r = render(renderer, i % 2 ? other : snapshot);
        if (r.ok && r.image.color == expected.color && r.image.depth == expected.depth) ++equal;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(equal, 40);
}

#if defined(__SSE__)
TEST(Renderer, TheHostsFloatingPointSettingsStay) {
  frame::Renderer renderer;
  const auto snapshot = makeSnapshot({makeMesh(test::squareData())});
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before & ~0x0200u & ~0x3Fu);  // traps division by zero
  const unsigned during = _mm_getcsr();
  const Rendered r = render(renderer, snapshot);
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_TRUE(r.ok);
  EXPECT_EQ(after, during);
}
#endif

}  // namespace
}  // namespace gluray

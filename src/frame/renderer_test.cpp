#include "frame/renderer.h"

#include "accel/test_scene.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

using test::makeMesh;
using test::makeSnapshot;

struct Rendered {
  Image image;
  frame::FrameStatistics statistics;
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

}  // namespace
}  // namespace gluray

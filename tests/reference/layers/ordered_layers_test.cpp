// transparency = ordered: surfaces drawn in any order look as the real OpenGL shows them drawn from back to
// front.
#include "tests/reference/layers/drawn_layers_stage.h"
#include "tests/reference/layers/peeling_stage.h"
#include "tests/reference/layers/summer.h"

#include <algorithm>
#include <numeric>

namespace gluray::test {
namespace {

Settings ordered() {
  Settings settings = TracedContext::vertexShading();
  settings.transparency = Transparency::ordered;
  return settings;
}

/// Red, green and blue alone.
DrawnImage visible(DrawnImage image) {
  for (uint32_t& color : image.colors) color |= 0xFF000000u;
  std::fill(image.depths.begin(), image.depths.end(), 1.0f);
  return image;
}

/// Expects that `ours` through GLuRay with ordered layers shows what `expected` shows in the real OpenGL.
gl::Statistics expectOrdered(const std::string& name, const ContextWish& wish, const Draw& expected,
                             const Draw& ours, const scenes::Tolerance& tolerance,
                             const std::function<DrawnImage(DrawnImage)>& compared) {
  SCOPED_TRACE(name);
  const DrawnImage real = [&] {
    const auto context = OsmesaContext::create(wish);
    expected(context->real());
    return compared(readImage(context->real(), wish.width, wish.height));
  }();
  TracedContext context(wish, ordered());
  ours(context.gl());
  const DrawnImage got = compared(context.read());
  const Comparison c = compare(real, got, tolerance);
  EXPECT_TRUE(c.accepted) << c.text;
  if (!c.accepted) writeFailure(TEST_OUTPUT "/ordered_layers", name, real, got);
  return context.context().counts.statistics;
}

TEST(OrderedLayers, OfFixedFunctionLookAsIfSorted) {
  using namespace drawn_layers;
  const BothStage stage = theStage();
  // Apart in depth, over each other in the window. Culled, so that no ball covers itself.
  const std::array<Ball, 3> balls = {Ball{-0.2f, 0.7f, {0.9f, 0.2f, 0.1f, 0.3f}, 0.3f},
                                     Ball{0, 0, {0.2f, 0.8f, 0.3f, 0.6f}, 0.3f},
                                     Ball{0.2f, -0.7f, {0.2f, 0.3f, 0.9f, 0.8f}, 0.3f}};
  std::array<size_t, 3> order{2, 1, 0};  // back to front
  const auto drawIn = [&](const std::array<size_t, 3>& which, bool writes) {
    return [&, which, writes](Gl gl) {
      stage.prepare(gl);
      gl.Enable(GL_CULL_FACE);
      blendOver(gl);
      gl.DepthMask(writes);
      for (const size_t i : which) ball(gl, balls[i]);
    };
  };
  for (const bool writes : {false, true}) {
    const Draw sorted = drawIn({2, 1, 0}, writes);
    std::sort(order.begin(), order.end());
    do {
      const gl::Statistics counted =
          expectOrdered("drawn", {stage.width, stage.height}, sorted, drawIn(order, writes), stage.tolerance,
                        [](DrawnImage whole) { return whole; });
      EXPECT_EQ(counted.drawsTraced, 3u);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

/// Both methods leave alphas and depths of their own.
TEST(OrderedLayers, OfWeightedSumsLookAsIfPeeled) {
  const ContextWish wish{kProgramWidth, kProgramHeight, true};
  const auto peel = [](Gl gl) {
    Peeler peeler(gl);
    peeler.frame(balls());
  };
  const auto sum = [](Gl gl) {
    Summer summer(gl);
    summer.frame(balls());
  };
  const gl::Statistics counted = expectOrdered("summed", wish, peel, sum, kPeelTolerance, visible);
  EXPECT_EQ(counted.drawsTraced, 4u);
}

}  // namespace
}  // namespace gluray::test

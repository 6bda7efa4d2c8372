// The tracer fails for some images: each failure costs what it concerns (scene::Loss), and every image is
// the real OpenGL's.
#include "base/files.h"
#include "frame/testing/test_renderer.h"
#include "intercept/present/tracing_presenter.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace gluray::test::failing_traces {
namespace {

using Gl = const gl::RealGl&;

constexpr int kSize = 64;

/// Two triangles at a place that depends on the frame.
void drawFrame(Gl gl, int frame) {
  const float x = 0.05f * static_cast<float>(frame % 8);
  gl.Viewport(0, 0, kSize, kSize), gl.Enable(GL_DEPTH_TEST), gl.ClearColor(0.1f, 0.2f, 0.3f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(1, 0, 0), gl.Vertex3f(-0.8f + x, -0.7f, 0), gl.Vertex3f(0.6f, -0.6f, 0.1f),
      gl.Vertex3f(0, 0.8f, 0.2f);
  gl.Color3f(0, 1, 0), gl.Vertex3f(-0.6f, 0.7f, 0.3f), gl.Vertex3f(0.7f, 0.6f, -0.2f),
      gl.Vertex3f(x, -0.8f, 0.1f);
  gl.End();
}

struct Outcome {
  std::vector<bool> traced;  // of each frame
  std::string said;
  gl::Statistics counts;
};

/// Draws frames of which those in `failing` cannot be traced, and compares each with the real OpenGL's.
Outcome frames(int count, const std::vector<int>& failing, scene::Loss loss) {
  int frame = 0;
  const auto trace = [&](const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                         std::string& error) {
    if (std::ranges::find(failing, frame) == failing.end())
      return testRenderer().render(snapshot, image, cost, error);
    cost.loss = loss;
    return error = "this test lets tracing fail", false;
  };
  const auto real = OsmesaContext::create({kSize, kSize});
  std::vector<DrawnImage> expected;
  for (int i = 0; i < count; ++i) {
    drawFrame(real->real(), i);
    expected.push_back(readImage(real->real(), kSize, kSize));
  }
  Outcome outcome;
  testing::internal::CaptureStderr();
  files::ownStreams();
  TracedContext ours({kSize, kSize}, TracedContext::tracing(),
                     std::make_unique<present::TracingPresenter>(frame::Tracer{trace}));
  for (; frame < count; ++frame) {
    const uint64_t before = ours.context().counts.statistics.drawsRasterised;
    drawFrame(ours.gl(), frame);
    const Comparison c = compare(expected[static_cast<size_t>(frame)], ours.read(), {});
    EXPECT_TRUE(c.accepted) << "frame " << frame << ": " << c.text;
    outcome.traced.push_back(ours.context().counts.statistics.drawsRasterised == before);
  }
  outcome.said = testing::internal::GetCapturedStderr();
  outcome.counts = ours.context().counts.statistics;
  return outcome;
}

uint64_t because(const Outcome& outcome, gl::Reason reason) {
  return outcome.counts.rasterisedBecause[static_cast<size_t>(reason)];
}

TEST(FailingTraces, WhatCannotBeTracedCostsItsFrameAlone) {
  const Outcome outcome = frames(6, {1, 2, 4}, scene::Loss::draws);
  EXPECT_EQ(outcome.traced, (std::vector<bool>{true, false, false, true, false, true}));
  EXPECT_EQ(because(outcome, gl::Reason::untraceable), 3u);
  EXPECT_EQ(outcome.said, "");
}

TEST(FailingTraces, AShortageCostsSomeFrames) {
  const Outcome outcome = frames(9, {1, 3}, scene::Loss::frames);
  // The pause after the first failure ends with the next clear, that after the second with the one after it.
  EXPECT_EQ(outcome.traced, (std::vector<bool>{true, false, true, false, false, true, true, true, true}));
  EXPECT_GT(because(outcome, gl::Reason::shortage), 1u);
  EXPECT_EQ(std::ranges::count(outcome.said, '\n'), 1) << outcome.said;
  EXPECT_NE(outcome.said.find("out of memory"), std::string::npos) << outcome.said;
}

TEST(FailingTraces, BrokenStateEndsTracing) {
  const Outcome outcome = frames(4, {1}, scene::Loss::tracing);
  EXPECT_EQ(outcome.traced, (std::vector<bool>{true, false, false, false}));
  EXPECT_EQ(std::ranges::count(outcome.said, '\n'), 1) << outcome.said;
}

}  // namespace
}  // namespace gluray::test::failing_traces

#include "tests/lag/lag_stage.h"

#include "frame/testing/test_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gluray::test {
namespace {

constexpr scenes::Tolerance kLagTolerance = {3, 0.01, 1e-4f,
                                             "silhouettes fall on either side of a pixel's centre"};

gl::LagWindow windowOf(const LagOptions& options, const std::function<void()>& swap) {
  gl::LagWindow window;
  window.stands = options.stands;
  window.swap = swap;
  window.overdue.size = {kLagWidth, kLagHeight};
  window.overdue.buffer = GL_FRONT;  // OSMesa has no other
  window.overdue.show = options.overdue;
  return window;
}

}  // namespace

bool traceByRenderer(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                     std::string& why) {
  return testRenderer().render(snapshot, image, cost, why);
}

Shown play(const DrawFrame& draw, int count, const LagOptions& options) {
  Shown shown;
  TracedContext ours({kLagWidth, kLagHeight}, options.settings,
                     std::make_unique<present::TracingPresenter>(
                         frame::Tracer{options.trace ? options.trace : traceByRenderer}));
  gl::Context& context = *gl::t_thread.context;
  const auto swap = [&] { shown.frames.push_back(readImage(ours.below().real(), kLagWidth, kLagHeight)); };
  for (int frame = 0; frame < count; ++frame) {
    draw(ours.gl(), frame);
    const gl::LagRefusal refusal =
        options.lag ? context.frames.lag(windowOf(options, swap)) : gl::LagRefusal::single;
    if (refusal != gl::LagRefusal::none) context.frames.beforeSwap(), swap();
    context.frames.afterSwap();
    shown.swaps.push_back(refusal);
    shown.shownAtSwap.push_back(shown.frames.size());
    if (options.afterSwap) options.afterSwap(ours.gl(), frame);
  }
  ours.gl().Finish();
  for (GLenum error = ours.gl().GetError(); error != GL_NO_ERROR; error = ours.gl().GetError())
    shown.errors.push_back(std::to_string(error));
  return shown;
}

std::vector<DrawnImage> playReal(const DrawFrame& draw, int count) {
  const auto real = OsmesaContext::create({kLagWidth, kLagHeight});
  std::vector<DrawnImage> frames;
  for (int frame = 0; frame < count; ++frame) {
    draw(real->real(), frame);
    frames.push_back(readImage(real->real(), kLagWidth, kLagHeight));
  }
  return frames;
}

void expectClose(const std::string& name, const std::vector<DrawnImage>& expected,
                 const std::vector<DrawnImage>& got) {
  ASSERT_EQ(got.size(), expected.size()) << name;
  for (size_t i = 0; i < got.size(); ++i) {
    const Comparison compared = compare(expected[i], got[i], kLagTolerance);
    EXPECT_TRUE(compared.accepted) << name << ", frame " << i << ": " << compared.text;
    if (!compared.accepted) writeFailure(TEST_OUTPUT "/lag", name, expected[i], got[i]);
  }
}

Shown expectSameFrames(const std::string& name, const DrawFrame& draw, int count, int later,
                       const LagOptions& options) {
  LagOptions plainly = options;
  plainly.lag = false;
  const Shown plain = play(draw, count, plainly);
  Shown lagged = play(draw, count, options);
  expectClose(name, playReal(draw, count), lagged.frames);
  EXPECT_EQ(lagged.errors, plain.errors);
  EXPECT_EQ(std::count(lagged.swaps.begin(), lagged.swaps.end(), gl::LagRefusal::none), later);
  for (size_t i = 0; i < std::min(lagged.frames.size(), plain.frames.size()); ++i)
    EXPECT_TRUE(lagged.frames[i] == plain.frames[i]) << name << " differs from the frame without lag: " << i;
  return lagged;
}

void beginLagFrame(const gl::RealGl& gl, int frame) {
  gl.Viewport(0, 0, kLagWidth, kLagHeight);
  gl.MatrixMode(GL_PROJECTION), gl.LoadIdentity();
  gl.Frustum(-0.13, 0.13, -0.1, 0.1, 0.3, 20);
  gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity();
  gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.ClearColor(0.2f, 0.1f * static_cast<float>(frame % 8), 0.4f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void drawRing(const gl::RealGl& gl, int frame) {
  constexpr int kFacets = 40;
  gl.PushMatrix();
  gl.Translatef(0, 0, -4), gl.Rotatef(25, 1, 0, 0), gl.Rotatef(20.0f * static_cast<float>(frame), 0, 1, 0);
  gl.Begin(GL_QUAD_STRIP);
  for (int i = 0; i <= kFacets; ++i) {
    const float t = 2 * static_cast<float>(M_PI) * static_cast<float>(i) / kFacets;
    gl.Normal3f(std::cos(t), 0, std::sin(t));
    gl.Vertex3f(std::cos(t), -0.5f, std::sin(t));
    gl.Vertex3f(std::cos(t), 0.4f + 0.2f * std::sin(3 * t), std::sin(t));
  }
  gl.End();
  gl.PopMatrix();
}

void drawFrameNumber(const gl::RealGl& gl, int frame) {
  gl.Disable(GL_LIGHTING);
  gl.LineWidth(4);
  gl.Color3f(1, 1, 0);
  gl.Begin(GL_LINES);
  gl.Vertex3f(-1.2f, -1, -3), gl.Vertex3f(-1.2f, -1 + 0.2f * static_cast<float>(frame), -3);
  gl.End();
  gl.Enable(GL_LIGHTING);
}

}  // namespace gluray::test

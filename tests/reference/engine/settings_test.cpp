// A frame keeps the settings from its beginning; the next frame takes those stored since.
#include "gl/basics/thread_state.h"
#include "scenes/stage.h"
#include "settings/live/settings_source.h"
#include "tests/reference/framebuffer.h"
#include "tests/support/snapshot_taker.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace gluray::test {
namespace {

using scenes::Gl;

constexpr int kSettingsSize = 96;

/// Adds the settings of its batches to `seen`.
std::unique_ptr<gl::Presenter> takeSettings(std::vector<Settings>& seen) {
  return std::make_unique<SnapshotTaker>([&seen](const scene::Snapshot& s) { seen.push_back(s.settings); });
}

/// One batch: the next call uses another depth function.
void drawBatch(Gl gl, GLenum depthFunction) {
  gl.DepthFunc(depthFunction);
  scenes::sendAt(gl, scenes::sphere(6, 8), depthFunction == GL_LESS ? -0.7f : 0.7f, 0, 0, 0.6f);
}

/// Two batches, with `between` in between.
void drawSquares(Gl gl, const std::function<void()>& between = {}) {
  scenes::begin(gl, kSettingsSize, kSettingsSize);
  scenes::camera(gl, kSettingsSize, kSettingsSize);
  scenes::keyLight(gl);
  drawBatch(gl, GL_LESS);
  if (between) between();
  drawBatch(gl, GL_LEQUAL);
  gl.Finish();
}

Settings other() {
  Settings settings = TracedContext::vertexShading();
  settings.shading = ShadingRate::pixel, settings.spp = 4, settings.bvh = BvhQuality::full;
  settings.quirks.set("spp-fxaa", false);
  return settings;
}

TEST(SettingsOfFrames, AStoreTakesEffectFromTheNextFrameOn) {
  std::vector<Settings> seen;
  const Settings first = TracedContext::vertexShading();
  SettingsSource source(first);
  TracedContext context({kSettingsSize, kSettingsSize}, first, takeSettings(seen), nullptr, familiesOfTests(),
                        &source);
  drawSquares(context.gl(), [&] { source.store(other()); });
  EXPECT_EQ(seen, (std::vector<Settings>{first, first}));
  EXPECT_EQ(context.context().settings.now(), other());
  seen.clear();
  drawSquares(context.gl());
  EXPECT_EQ(seen, (std::vector<Settings>{other(), other()}));
  seen.clear();
  source.store(first);  // between frames: the first clear takes it
  drawSquares(context.gl());
  EXPECT_EQ(seen, (std::vector<Settings>{first, first}));
}

TEST(SettingsOfFrames, AClearAfterDrawsBeginsNoFrame) {
  std::vector<Settings> seen;
  const Settings first = TracedContext::vertexShading();
  SettingsSource source(first);
  TracedContext context({kSettingsSize, kSettingsSize}, first, takeSettings(seen), nullptr, familiesOfTests(),
                        &source);
  Gl gl = context.gl();
  gl.Enable(GL_DEPTH_TEST);
  drawBatch(gl, GL_LESS);  // without a clear
  source.store(other());
  drawSquares(gl);
  EXPECT_EQ(seen, (std::vector<Settings>{first, first, first}));
}

/// A program that never swaps draws into a framebuffer object and reads each picture.
TEST(SettingsOfFrames, PicturesInMemoryAreFrames) {
  std::vector<Settings> seen;
  const Settings first = TracedContext::vertexShading();
  SettingsSource source(first);
  TracedContext context({kSettingsSize, kSettingsSize}, first, takeSettings(seen), nullptr, familiesOfTests(),
                        &source);
  Gl gl = context.gl();
  bindNewFramebuffer(gl, {kSettingsSize, kSettingsSize}, GL_RGBA8, GL_DEPTH_COMPONENT24);
  gl.Enable(GL_DEPTH_TEST);
  const auto draw = [&](bool reads) {
    std::vector<uint32_t> pixels(size_t{kSettingsSize} * kSettingsSize);
    scenes::begin(gl, kSettingsSize, kSettingsSize);
    scenes::camera(gl, kSettingsSize, kSettingsSize);
    drawBatch(gl, GL_LESS), drawBatch(gl, GL_LEQUAL);
    if (reads) gl.ReadPixels(0, 0, kSettingsSize, kSettingsSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  };
  const auto frames = [&] {
    return static_cast<uint64_t>(context.context().counts.statistics.framesInMemory);
  };
  draw(true);
  source.store(other());
  draw(true);
  EXPECT_EQ(seen, (std::vector<Settings>{first, first, other(), other()}));
  EXPECT_EQ(frames(), 1u) << "the second one has not ended";
  source.store(first);
  draw(false);
  EXPECT_EQ(seen.back(), first);
  EXPECT_EQ(frames(), 2u);
  source.store(other());
  draw(true);
  EXPECT_EQ(seen.back(), first) << "nobody has seen what the clear has removed";
  EXPECT_EQ(frames(), 2u);
}

/// The ranks of a job read different numbers of pictures, but swap equally often.
TEST(SettingsOfFrames, PicturesInMemoryAreNoSwaps) {
  std::vector<std::pair<uint64_t, uint64_t>> seen;  // frames and swaps
  TracedContext context({kSettingsSize, kSettingsSize}, TracedContext::vertexShading(),
                        std::make_unique<SnapshotTaker>([&seen](const scene::Snapshot& s) {
                          seen.push_back({s.frame, s.swaps});
                        }));
  Gl gl = context.gl();
  const auto draw = [&] {
    std::vector<uint32_t> pixels(size_t{kSettingsSize} * kSettingsSize);
    scenes::begin(gl, kSettingsSize, kSettingsSize);
    scenes::camera(gl, kSettingsSize, kSettingsSize);
    drawBatch(gl, GL_LESS);
    gl.ReadPixels(0, 0, kSettingsSize, kSettingsSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  };
  bindNewFramebuffer(gl, {kSettingsSize, kSettingsSize}, GL_RGBA8, GL_DEPTH_COMPONENT24);
  gl.Enable(GL_DEPTH_TEST);
  draw(), draw();
  gl::FrameEnds& frames = gl::t_thread.context->frames;
  frames.beforeSwap(), frames.afterSwap();
  draw();
  EXPECT_EQ(seen, (std::vector<std::pair<uint64_t, uint64_t>>{{1, 0}, {2, 0}, {3, 1}}));
}

TEST(SettingsOfFrames, SettingsOfContextsStay) {
  SettingsSource source(TracedContext::vertexShading());
  Settings next = other();
  next.threads = 3, next.renderer = Renderer::null;
  TracedContext old({kSettingsSize, kSettingsSize}, {}, nullptr, nullptr, familiesOfTests(), &source);
  source.store(next);
  drawSquares(old.gl());
  EXPECT_EQ(old.context().settings.now(), other());
  const TracedContext fresh({kSettingsSize, kSettingsSize}, {}, nullptr, nullptr, familiesOfTests(), &source);
  EXPECT_EQ(fresh.context().settings.now(), next);
  EXPECT_EQ(old.context().settings.now(), other());
}

/// The image of a frame in a context that has these settings from its first frame on.
DrawnImage imageWith(const Settings& settings) {
  TracedContext context({kSettingsSize, kSettingsSize}, settings);
  drawSquares(context.gl());
  return context.read();
}

TEST(SettingsOfFrames, ImagesFollow) {
  const Settings first = TracedContext::vertexShading();
  const DrawnImage before = imageWith(first), after = imageWith(other());
  EXPECT_NE(before.colors, after.colors);
  SettingsSource source(first);
  TracedContext context({kSettingsSize, kSettingsSize}, first, nullptr, nullptr, familiesOfTests(), &source);
  drawSquares(context.gl(), [&] { source.store(other()); });
  EXPECT_EQ(context.read().colors, before.colors);
  drawSquares(context.gl());
  EXPECT_EQ(context.read().colors, after.colors);
  EXPECT_EQ(context.read().depths, after.depths);
}

TEST(SettingsOfFrames, SmallScenesAreTracedIfASettingChangesTheImage) {
  Settings automatic = TracedContext::vertexShading();
  automatic.engine = Engine::automatic;
  SettingsSource source(automatic);
  TracedContext context({kSettingsSize, kSettingsSize}, automatic, nullptr, nullptr, familiesOfTests(),
                        &source);
  const auto tracedIn = [&](int frames) {
    const uint64_t before = context.context().counts.statistics.drawsTraced;
    for (int i = 0; i < frames; ++i) drawSquares(context.gl());
    return context.context().counts.statistics.drawsTraced - before;
  };
  EXPECT_EQ(tracedIn(1), 0u);  // so few triangles are left to the real OpenGL
  Settings smooth = automatic;
  smooth.spp = 4;
  source.store(smooth);
  tracedIn(1);
  EXPECT_EQ(tracedIn(3), 6u);
  Settings never = smooth;
  never.engine = Engine::never;
  source.store(never);
  tracedIn(1);
  EXPECT_EQ(tracedIn(3), 0u);
}

}  // namespace
}  // namespace gluray::test

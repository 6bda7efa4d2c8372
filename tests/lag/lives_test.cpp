// Frame lag beside the program's own thread: state, frames shown without the program, destroyed contexts.
#include "tests/lag/lag_stage.h"
#include "tests/support/gl_state.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace gluray::test {
namespace {

using gl::LagRefusal;
using Gl = const gl::RealGl&;

TEST(Lag, StateIsThatOfTheProgram) {
  const auto draw = [](Gl gl) {
    for (int frame = 0; frame < 2; ++frame) ringFrame(gl, frame);
  };
  const auto real = OsmesaContext::create({kLagWidth, kLagHeight});
  draw(real->real());
  const GlState expected = queryState(real->real());
  GlState got;
  LagOptions options;
  options.afterSwap = [&](Gl gl, int frame) {
    if (frame == 1) got = queryState(gl);
  };
  play(ringFrame, 2, options);
  std::vector<std::string> lines = differences(expected, got);
  std::erase_if(lines, [](const std::string& line) {  // addresses differ from run to run
    return line.find("pointer") != line.npos || line.find("POINTER") != line.npos;
  });
  EXPECT_EQ(lines, std::vector<std::string>{});
}

TEST(Lag, WithoutTheProgramTheNewestFrameIsShownWhole) {
  struct Late {
    std::mutex mutex;
    std::condition_variable came;
    std::vector<uint32_t> pixels;
  } late;
  LagOptions options;
  options.overdue = [&](const uint32_t* pixels) {
    const std::lock_guard lock(late.mutex);
    late.pixels.assign(pixels, pixels + static_cast<size_t>(kLagWidth) * kLagHeight);
    late.came.notify_all();
  };
  std::vector<std::vector<uint32_t>> shownLate;
  options.afterSwap = [&](Gl, int) {
    std::unique_lock lock(late.mutex);
    EXPECT_TRUE(late.came.wait_for(lock, std::chrono::seconds(60), [&] { return !late.pixels.empty(); }));
    shownLate.push_back(std::exchange(late.pixels, {}));
  };
  const auto draw = [](Gl gl, int frame) {
    beginLagFrame(gl, frame);
    drawFrameNumber(gl, frame);
    drawRing(gl, frame);
  };
  const Shown shown = play(draw, kLagFrames, options);
  ASSERT_EQ(shown.frames.size(), shownLate.size());
  for (size_t i = 0; i < shownLate.size(); ++i) EXPECT_EQ(shownLate[i], shown.frames[i].colors) << i;
}

TEST(Lag, AContextMayBeDestroyedWithAPendingFrame) {
  TracedContext ours({kLagWidth, kLagHeight});
  ringFrame(ours.gl(), 0);
  gl::LagWindow window;
  int swaps = 0;
  window.stands = [] { return true; };
  window.swap = [&] { ++swaps; };
  window.overdue.buffer = GL_FRONT;
  EXPECT_EQ(gl::t_thread.context->frames.lag(window), LagRefusal::none);
  EXPECT_EQ(swaps, 0);
  gl::t_thread.context->loseCurrent();
  EXPECT_EQ(swaps, 1);
}

}  // namespace
}  // namespace gluray::test

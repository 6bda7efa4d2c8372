// Frames of a program with a clock of its own: each draw that is made takes a second, so that what GLuRay
// measures, and decides, is known. Compared with whole draws to the bit.
#pragma once
#include "tests/reference/culled/small_scene.h"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gluray::test::culled {

struct SimulatedTime {
  double now = 0;
  std::function<double()> step;  // seconds between two times that GLuRay reads
  const gl::Context* context = nullptr;
};
inline SimulatedTime g_time;

inline double simulatedSeconds() { return g_time.now += g_time.step(); }

inline void drawElementsInTime(GLenum mode, GLsizei count, GLenum type, const void* indices) {
  const gl::Statistics& counts = g_time.context->counts.statistics;
  const uint64_t before = counts.drawsCulled;
  TracedContext::stubs().DrawElements(mode, count, type, indices);
  if (counts.drawsCulled == before) g_time.now += 1;
}

/// Draws frames with `cull.draws = auto`, and whole. Returns how many draws were left out of each frame.
inline std::vector<uint64_t> compareTimedFrames(const std::string& name, int frames,
                                                const std::function<void(Gl, const SmallScene&, int)>& draw,
                                                const std::function<double()>& step, int verify = 0) {
  std::vector<uint64_t> leftOut;
  const auto seen = [&](Culling how) {
    Settings settings = smallDraws(how);
    settings.cull.verify = verify;
    TracedContext context(kCompatible, settings, nullptr, nullptr, familiesOfTests(), nullptr,
                          simulatedSeconds);
    g_time = {0, step, &context.context()};
    gl::RealGl gl = context.gl();
    gl.DrawElements = drawElementsInTime;
    SmallScene scene;
    scene.prepare(gl);
    Frames all;
    for (int frame = 0; frame < frames; ++frame) {
      const uint64_t before = context.context().counts.statistics.drawsCulled;
      scene.begin(gl), draw(gl, scene, frame);
      EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
      GlState state = queryState(gl);
      gl.Finish();  // the frame ends
      all.emplace_back(readWindow(gl), std::move(state));
      if (how != Culling::off) leftOut.push_back(context.context().counts.statistics.drawsCulled - before);
    }
    return all;
  };
  const auto whole = seen(Culling::off), culled = seen(Culling::automatic);
  expectSameFrames(name, whole, culled);
  return leftOut;
}

}  // namespace gluray::test::culled

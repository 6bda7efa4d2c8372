// A floor and a wall that shades it, drawn in steps, with ambient occlusion: for tests of views (adr/0047,
// adr/0095).
#pragma once
#include "tests/reference/engine/quad.h"
#include "tests/support/traced_context.h"

#include <functional>
#include <vector>

namespace gluray::test::lit {

inline constexpr int kLitViewSize = 64;
using Gl = const gl::RealGl&;
using Step = std::function<void(Gl)>;

/// A slightly tilted floor that fills the window.
inline void floor(Gl gl) {
  gl.Color4f(1, 1, 1, 1);
  quad(gl, {-1, -1, 0.5f}, {1, -1, 0.51f}, {1, 1, 0.51f}, {-1, 1, 0.5f});
}
/// On it at the right, seen edge-on: nearly nothing of it is visible.
inline void wall(Gl gl) {
  gl.Color4f(1, 1, 1, 1);
  quad(gl, {0.9f, -1, 0.51f}, {0.95f, -1, -0.9f}, {0.95f, 1, -0.9f}, {0.9f, 1, 0.51f});
}
inline void nothing(Gl) {}

inline Settings coarseAo(bool on = true) {
  Settings settings = TracedContext::tracing();
  settings.ao.enabled = on;
  settings.ao.samples = 64;
  settings.noise = 0;  // images of different surfaces would take different numbers of passes
  settings.ao.distance = 2;
  return settings;
}

class LitProgram {
 public:
  explicit LitProgram(const Settings& settings) : context_({kLitViewSize, kLitViewSize}, settings) {
    gl().Enable(GL_DEPTH_TEST);
    gl().ClearColor(0, 0, 0, 0);
  }
  Gl gl() const { return context_.gl(); }
  DrawnImage frame(const std::vector<Step>& steps) {
    context_.makeCurrent();
    gl().DepthFunc(GL_LESS);
    gl().Viewport(0, 0, kLitViewSize, kLitViewSize);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const Step& step : steps) step(gl());
    gl().Finish();
    return context_.read();
  }
  const gl::Statistics& statistics() const { return context_.context().counts.statistics; }
  const gl::ViewScenes& views() const { return context_.context().surfaces.views; }

 private:
  TracedContext context_;
};

inline DrawnImage frameOf(const std::vector<Step>& steps, const Settings& settings = coarseAo()) {
  return LitProgram(settings).frame(steps);
}

/// Red of the floor's pixels, left of the wall.
inline std::vector<int> floorOf(const DrawnImage& image) {
  std::vector<int> result;
  for (int y = 4; y < kLitViewSize - 4; ++y)
    for (int x = 4; x < 60; ++x)
      result.push_back(static_cast<int>(image.colors[static_cast<size_t>(y * kLitViewSize + x)] & 255));
  return result;
}

/// What follows is another batch.
inline const Step kSplit = [](Gl gl) { gl.DepthFunc(GL_LEQUAL); };

}  // namespace gluray::test::lit

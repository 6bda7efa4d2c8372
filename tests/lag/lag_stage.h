// Simulates a double-buffered window whose swaps may be delayed, without a real window. Keeps every frame
// that is shown, to be compared with the real OpenGL's frames of the same calls.
#pragma once
#include "intercept/present/tracing_presenter.h"
#include "tests/support/traced_context.h"

#include <functional>
#include <string>
#include <vector>

namespace gluray::test {

inline constexpr int kLagWidth = 96, kLagHeight = 72, kLagFrames = 6;
/// The calls of one frame, from 0.
using DrawFrame = std::function<void(const gl::RealGl&, int frame)>;

struct Shown {
  std::vector<DrawnImage> frames;     // in the order they were shown
  std::vector<gl::LagRefusal> swaps;  // for each swap, whether it lagged or why not
  std::vector<size_t> shownAtSwap;    // how many frames had been shown when it returned
  std::vector<std::string> errors;
};

struct LagOptions {
  bool lag = true;
  Settings settings = TracedContext::vertexShading();
  std::function<bool()> stands = [] { return true; };      // whether the window still exists
  std::function<void(const uint32_t*)> overdue = nullptr;  // shows a frame without the program
  std::function<void(const gl::RealGl&, int)> afterSwap;   // calls after the swap of a frame
  frame::Trace trace;                                      // in place of the ray tracer
};

/// The ray tracer.
bool traceByRenderer(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost, std::string& why);

/// Draws `count` frames through GLuRay; glFinish shows the last one.
Shown play(const DrawFrame& draw, int count, const LagOptions& options = {});
/// The same by the real OpenGL alone.
std::vector<DrawnImage> playReal(const DrawFrame& draw, int count);

/// Expects the same number of images, and each within the scenes' tolerance.
void expectClose(const std::string& name, const std::vector<DrawnImage>& expected,
                 const std::vector<DrawnImage>& got);

/// Expects the same frames in the same order as without lag, to the bit, and those of the real OpenGL within
/// the scenes' tolerance; and that `later` of the swaps were delayed.
Shown expectSameFrames(const std::string& name, const DrawFrame& draw, int count, int later,
                       const LagOptions& options = {});

/// A lit ring, turned by some degrees a frame, sent by glBegin.
void drawRing(const gl::RealGl& gl, int frame);
/// Depth test, camera, light, and a clear of all.
void beginLagFrame(const gl::RealGl& gl, int frame);
/// beginLagFrame() and drawRing().
inline void ringFrame(const gl::RealGl& gl, int frame) { beginLagFrame(gl, frame), drawRing(gl, frame); }
/// A rectangle at the left, two lines wide; the real OpenGL draws the lines.
void drawFrameNumber(const gl::RealGl& gl, int frame);

}  // namespace gluray::test

// Tracks the process's OpenGL contexts and the thread in which each is current. The hooks of GLX, EGL and
// OSMesa call these functions before and after the real ones. None of them throws. Any thread.
#pragma once
#include "gl/basics/statistics.h"
#include "gl/counts/draw_kinds.h"
#include "intercept/window_systems/real_functions.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gluray::intercept {

/// The drawables that a context draws into and reads from: XIDs for GLX, pointers otherwise.
struct Drawables {
  uintptr_t draw = 0, read = 0;
  bool operator==(const Drawables&) const = default;
};
/// Returns width and height of a drawable in pixels; {0, 0} if unknown. Called on the thread where it is
/// current.
using AskSize = std::function<glm::ivec2()>;
/// Whether a drawable is a window that the user sees. Called like AskSize; empty: no.
using AskShown = std::function<bool()>;

/// Reports that a context was created. `share`: the context whose lists and buffers it shares, or null.
/// `display`: EGL's display, or null.
void contextCreated(Api api, const void* handle, const void* share, const void* display = nullptr) noexcept;
/// Reports that a context was destroyed. While it is current, it stays alive (GLX 1.4, 3.3.7).
void contextDestroyed(Api api, const void* handle) noexcept;
/// Reports that all contexts of an EGL display were destroyed.
void displayTerminated(const void* display) noexcept;

/// Flushes the current context's pending draws, before anything reads or shows its framebuffer.
void flushCurrent() noexcept;
/// Flushes pending draws, then runs `call`, the real function.
template <class F>
auto afterFlush(F&& call) {
  const Outermost outermost;
  if (outermost) flushCurrent();
  return call();
}
/// Call before the real MakeCurrent: flushes the current context's pending draws while its framebuffer is
/// accessible.
void leaveCurrent() noexcept;
/// Reports that the real MakeCurrent failed, so that the previous context is still current.
void stayCurrent() noexcept;
/// Reports that a drawable became the image of a bound texture of the current context.
void textureImageBound() noexcept;
/// Reports that the real MakeCurrent succeeded: `handle` (null: none) is current in this thread with these
/// drawables. `size` and `shown` query the draw drawable.
void becameCurrent(Api api, const void* handle, Drawables drawables, AskSize size = {},
                   AskShown shown = {}) noexcept;
/// Whether exactly this is already current. Many programs repeat MakeCurrent every frame, which then changes
/// nothing.
bool isCurrent(Api api, const void* handle, Drawables drawables) noexcept;
/// Call before a drawable is destroyed.
void drawableGoing(uintptr_t drawable) noexcept;

/// Call in the child of a fork, which has no renderer threads: all calls are passed through from now on.
void passThroughAfterFork() noexcept;

/// One context, for reports.
struct ContextSummary {
  std::string api, profile, version, renderer;
  bool doubleBuffered = true;
  uint64_t frames = 0;
  bool swaps = false;
  uint64_t drawsTraced = 0, drawsRasterised = 0;
};

/// Statistics of all contexts, including destroyed ones.
struct Totals {
  gl::Statistics statistics;
  std::map<std::string, uint64_t> unknownCalls;  // by name
  std::string vendor, renderer, version;         // of the real OpenGL, from the first context made current
  int contexts = 0;
  // Only for `gluray explain`:
  gl::KindTable kinds;
  std::map<gl::CullReason, uint64_t> notCulled;  // large draws
  std::map<gl::LightReason, uint64_t> notLit;
  gl::TargetTable targets;
  gl::ProgramTable programs;
  std::vector<ContextSummary> list;
};
Totals totals();
/// Stops recording draws by kind.
void closeKinds() noexcept;

}  // namespace gluray::intercept

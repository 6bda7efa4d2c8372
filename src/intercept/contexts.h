// Every OpenGL context of the process and which thread has it current. Hooks of GLX, EGL and OSMesa call
// these around the real functions; none of them throws. Any thread.
#pragma once
#include "gl/draws/draw_kinds.h"
#include "gl/statistics.h"
#include "intercept/window_systems/real_functions.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gluray::intercept {

/// What a context draws into and reads from: XIDs of GLX, pointers elsewhere.
struct Drawables {
  uintptr_t draw = 0, read = 0;
  bool operator==(const Drawables&) const = default;
};
/// Width and height of a drawable in pixels; {0, 0} where they cannot be found out. Called on the thread
/// where it is current.
using AskSize = std::function<glm::ivec2()>;

/// A context was made. `share` is the context whose lists and buffers it shares, or null. `display` is EGL's,
/// else null.
void contextCreated(Api api, const void* handle, const void* share, const void* display = nullptr) noexcept;
/// A context was destroyed; where it is current it lives on until it no longer is (GLX 1.4, 3.3.7).
void contextDestroyed(Api api, const void* handle) noexcept;
/// All contexts of an EGL display were destroyed.
void displayTerminated(const void* display) noexcept;

/// Draws what this thread's context holds back: before anything reads or shows its framebuffer.
void flushCurrent() noexcept;
/// Before the real MakeCurrent: what the current context holds back is drawn while its framebuffer can still
/// be reached.
void leaveCurrent() noexcept;
/// The real MakeCurrent failed: the context that was left is still current.
void stayCurrent() noexcept;
/// A drawable has become the image of a bound texture of the thread's context.
void textureImageBound() noexcept;
/// The real MakeCurrent succeeded: `handle` (null: none) is current in this thread with these drawables.
/// `size` says how large the one drawn into is.
void becameCurrent(Api api, const void* handle, Drawables drawables, AskSize size = {}) noexcept;
/// Whether exactly this is current already: many programs say it again every frame, and nothing changes then.
bool isCurrent(Api api, const void* handle, Drawables drawables) noexcept;
/// A buffer swap of `drawable` is about to happen: draws what is pending, and keeps the frame's picture where
/// one is wanted.
void swapping(uintptr_t drawable) noexcept;
/// A buffer swap of `drawable` returned: if this thread draws into it, a frame has ended.
void swapped(uintptr_t drawable) noexcept;
/// A drawable is about to be destroyed.
void drawableGoing(uintptr_t drawable) noexcept;

/// In the child of a fork: no renderer threads live here, so everything passes through from now on.
void passThroughAfterFork() noexcept;
bool isForkedChild() noexcept;

/// One context, for reports.
struct ContextSummary {
  std::string api, profile, version, renderer;
  bool doubleBuffered = true;
  uint64_t frames = 0;
  bool swaps = false;
  uint64_t drawsTraced = 0, drawsRasterised = 0;
};

/// What all contexts did, dead ones included.
struct Totals {
  gl::Statistics statistics;
  std::map<std::string, uint64_t> unknownCalls;  // by name
  std::string vendor, renderer, version;         // the real OpenGL's, of the context first made current
  int contexts = 0;
  // Only where somebody explains:
  gl::KindTable kinds;
  gl::TargetTable targets;
  gl::ProgramTable programs;
  std::vector<ContextSummary> list;
};
Totals totals();
/// Frames that the process has ended.
uint64_t framesEnded() noexcept;
/// No draw is recorded by kind from now on.
void closeKinds() noexcept;

}  // namespace gluray::intercept

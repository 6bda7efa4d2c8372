// Tells generated stubs whether they must ask Context::gate(), and vertex attribute calls where to write. A
// part of each Context, GL thread.
#pragma once
#include "gl/real/real.h"

namespace gluray::gl {

class FrameClock;
class Immediate;
class ListCompiler;

class Attention {
 public:
  /// `off`: every call passes through to the real OpenGL. `watched`: decisions are logged.
  Attention(const RealGl& real, bool off, bool watched, Immediate& immediate, const ListCompiler& lists,
            const FrameClock& clock)
      : real_(real), immediate_(immediate), lists_(lists), clock_(clock), off_(off), watched_(watched) {}

  /// True if stubs must ask Context::gate(): the context is off or watched, or calls come inside glBegin,
  /// while a run is open, while glBegin relies on an earlier answer, or while a list is compiled.
  explicit operator bool() const { return asked_; }
  /// The same if nobody watched.
  bool isNeeded() const { return needed_; }
  /// Call after any of these changes. Also sets where the calling thread's vertices go (t_thread).
  void update();
  /// The same if nothing changes but that glBegin or glEnd went to the real OpenGL in a passthrough frame.
  /// `inside`: calls come inside glBegin or while a run is open or a list is compiled.
  void passed(bool inside) { set(off_ || inside); }

 private:
  void set(bool needed) { needed_ = needed, asked_ = needed || watched_; }
  const RealGl& real_;
  Immediate& immediate_;
  const ListCompiler& lists_;
  const FrameClock& clock_;
  const bool off_, watched_;
  bool needed_ = false, asked_ = false;
};

}  // namespace gluray::gl

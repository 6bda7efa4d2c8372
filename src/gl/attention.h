// Whether generated stubs and vertex attribute calls may take their shortest way. A part of each Context, GL
// thread.
#pragma once
#include "gl/real.h"

namespace gluray::gl {

class FrameClock;
class Immediate;
class ListCompiler;

class Attention {
 public:
  /// `off`: every call goes to the real OpenGL.
  Attention(const RealGl& real, bool off, Immediate& immediate, const ListCompiler& lists,
            const FrameClock& clock)
      : real_(real), immediate_(immediate), lists_(lists), clock_(clock), off_(off) {}

  /// Whether stubs must ask Context::gate(): calls are passed through, inside glBegin, captured into a run,
  /// or compiled into a list.
  explicit operator bool() const { return needed_; }
  /// Call it after any of these has changed. Tells the calling thread where its vertices go.
  void update();

 private:
  const RealGl& real_;
  Immediate& immediate_;
  const ListCompiler& lists_;
  const FrameClock& clock_;
  const bool off_;
  bool needed_ = false;
};

}  // namespace gluray::gl

// Shader programs that no family describes: the real OpenGL makes their draws in any state. A part of each
// Context, GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/clock/frame_clock.h"
#include "gl/shadow/shadow_state.h"

#include <cstdint>
#include <memory>

namespace gluray::gl {

class UntracedPrograms {
 public:
  UntracedPrograms(ShadowState& shadow, const FrameClock& clock) : shadow_(shadow), clock_(clock) {}

  /// The reason why draws of the shader program in use are not traced in any state. Reason::traced: they may
  /// be traced, or no program is in use. Reads no state back. May throw std::bad_alloc.
  Reason inUse();
  /// Whether the program's shaders may read the draw's number in a multi-draw. Always true for a program
  /// pipeline, whose programs are not inspected.
  bool numbersDraws() { return inUse() == Reason::traced ? isPipeline() : numbersDraws_; }
  /// Whether the program takes its vertices from fixed function.
  bool readsFixedVertices() { return inUse() != Reason::traced && readsFixedVertices_; }
  /// Whether no family describes any linked shader program of the share group, so that no draw by a shader
  /// program will be traced. Recognises one unused program in each frame.
  bool areAll();

 private:
  GLuint nameInUse() const;
  /// Whether no program, but a program pipeline is in use.
  bool isPipeline();
  void find(GLuint name);

  ShadowState& shadow_;
  const FrameClock& clock_;
  GLuint name_ = 0;                 // the program of reason_
  Reason reason_ = Reason::traced;  // of name_ after changes_
  bool numbersDraws_ = false, readsFixedVertices_ = false;
  uint64_t changes_ = ~uint64_t{0};  // ShareGroup::programChanges() when reason_ was set
  bool areAll_ = false;              // valid for allChanges_
  uint64_t allChanges_ = ~uint64_t{0};
  uint64_t recognisedIn_ = 0;  // number of the frame
};

}  // namespace gluray::gl

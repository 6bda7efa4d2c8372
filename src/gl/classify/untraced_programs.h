// Programs that no family describes: the real OpenGL makes their draws, whatever the state is. A part of each
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

  /// Why draws of the shader program in use are not traced, whatever the state is. Reason::traced: they may
  /// be traced, or no program is in use. Reads no state back. May throw std::bad_alloc.
  Reason inUse();
  /// Whether its shaders may read which draw of a multi-draw they belong to. Those of a program pipeline are
  /// not inspected: they may.
  bool numbersDraws() { return inUse() == Reason::traced ? isPipeline() : numbersDraws_; }
  /// Whether it takes its vertices from fixed function.
  bool readsFixedVertices() { return inUse() != Reason::traced && readsFixedVertices_; }
  /// Whether all linked shader programs of the share group are such, so that no draw by a shader program will
  /// be traced. In each frame, recognises one that was not used yet.
  bool areAll();

 private:
  GLuint nameInUse() const;
  /// Whether no program is in use, but a program pipeline.
  bool isPipeline();
  void find(GLuint name);

  ShadowState& shadow_;
  const FrameClock& clock_;
  GLuint name_ = 0;                 // that reason_ is of
  Reason reason_ = Reason::traced;  // of name_ after changes_
  bool numbersDraws_ = false, readsFixedVertices_ = false;
  uint64_t changes_ = ~uint64_t{0};  // ShareGroup::programChanges() when reason_ was found
  bool areAll_ = false;              // after allChanges_
  uint64_t allChanges_ = ~uint64_t{0};
  uint64_t recognisedIn_ = 0;  // frame
};

}  // namespace gluray::gl

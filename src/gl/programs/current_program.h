// The shader program in use, and what is known of it. A part of ShadowState, GL thread.
#pragma once
#include "gl/context_info.h"
#include "gl/programs/program_state.h"
#include "gl/real.h"
#include "gl/share_group.h"

#include <GL/gl.h>

#include <memory>

namespace gluray::gl {

class CurrentProgram {
 public:
  CurrentProgram(const RealGl& real, ShareGroup& group, const ContextInfo& info)
      : real_(real), group_(group), info_(info) {}

  /// What is known of a program that is linked; null where it is not.
  std::shared_ptr<const KnownProgram> known(GLuint name) const;
  /// The program in use; 0: none.
  GLuint name() const;
  /// Whether it makes round impostors of what a draw of this mode sends.
  bool drawsImpostors(GLenum mode) const;

 private:
  const RealGl& real_;
  ShareGroup& group_;
  const ContextInfo& info_;
};

}  // namespace gluray::gl

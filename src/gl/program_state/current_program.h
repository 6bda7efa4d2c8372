// The shader program in use and its family. A part of ShadowState, GL thread.
#pragma once
#include "gl/clock/context_info.h"
#include "gl/program_state/program_state.h"
#include "gl/real/real.h"
#include "gl/sharing/share_group.h"

#include <GL/gl.h>

#include <memory>

namespace gluray::gl {

/// Whether the shader program turns the points or lines of a draw of this mode into impostors.
bool drawsImpostors(const KnownProgram& program, GLenum mode);

class CurrentProgram {
 public:
  CurrentProgram(const RealGl& real, ShareGroup& group, const ContextInfo& info)
      : real_(real), group_(group), info_(info) {}

  /// The shader program `name` and its family, which is determined once per link.
  std::shared_ptr<const KnownProgram> known(GLuint name) const;
  /// Name of the shader program in use; 0: none.
  GLuint name() const;
  /// Likewise of the shader program in use and the first of its families, which needs no values of uniforms.
  bool drawsImpostors(GLenum mode) const;
  /// Likewise: whether it casts rays through a volume.
  bool drawsVolumes() const;

 private:
  const RealGl& real_;
  ShareGroup& group_;
  const ContextInfo& info_;
};

}  // namespace gluray::gl

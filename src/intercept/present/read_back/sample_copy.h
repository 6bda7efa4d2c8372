// A copy of the depths of all samples of the program's framebuffer, in a multisampled texture. GL thread,
// context current; restores all state.
#pragma once
#include "gl/real/real.h"
#include "intercept/present/state/features.h"
#include "scene/snapshot.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <cstddef>

namespace gluray::present {

/// While it lives, draws, blits and clears go to a new framebuffer object, and blits come from the
/// framebuffer that was drawn into before.
class CopyFramebuffer {
 public:
  explicit CopyFramebuffer(const gl::RealGl& real);
  ~CopyFramebuffer();
  CopyFramebuffer(const CopyFramebuffer&) = delete;
  CopyFramebuffer& operator=(const CopyFramebuffer&) = delete;
  GLuint name() const { return name_; }

 private:
  const gl::RealGl& real_;
  GLint drawn_, read_;
  GLuint name_ = 0;
};

/// A multisampled depth texture, which the owner deletes. Its size: see grownSize().
struct SampleCopy {
  GLuint texture = 0;
  size_t format = 0;         // which of those that are tried
  glm::ivec2 size = {0, 0};  // texels
  GLsizei samples = 0;
};

/// Copies the depths of all samples in `region` of the bound draw framebuffer into the texture, from its
/// texel `to` on. Samples can only be copied between equal depth formats, and a window's format cannot
/// be queried: tries formats until one is accepted. False: none is. No error may be pending. Mesa (22.3) may
/// change the last of 24 bits.
bool copySamples(const gl::RealGl& real, const Features& features, const scene::Region& region,
                 GLsizei samples, SampleCopy& into, glm::ivec2 to = {0, 0});

/// Attaches it to the framebuffer that is bound for drawing.
void attachSamples(const gl::RealGl& real, const SampleCopy& copy);

}  // namespace gluray::present

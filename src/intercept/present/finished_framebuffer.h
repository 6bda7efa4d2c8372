// A copy of the bound read framebuffer in which images with light are finished, for a program that reads
// it. GL thread, context current.
#pragma once
#include "gl/batch/present_result.h"
#include "intercept/present/presented_images.h"
#include "intercept/present/state/state_guard.h"

namespace gluray::present {

class FinishedFramebuffer {
 public:
  /// Makes it and binds it for reading, if the program reads enough of the images, and the framebuffer
  /// shows them. Not traced: nothing was bound. Throws std::bad_alloc.
  gl::PresentResult bind(const gl::RealGl& real, PresentedImages& images, const scene::Region& read);
  /// Binds the framebuffer again that was bound before, and deletes the copy.
  void unbind(const gl::RealGl& real, const Features& features) noexcept;

 private:
  WindowPixels read(const gl::RealGl& real, StateGuard& guard, glm::ivec2 size) const;
  void make(const gl::RealGl& real, StateGuard& guard, const Features& features, const WindowPixels& pixels);

  GLuint program_ = 0;  // the program's framebuffer
  GLuint copy_ = 0, texture_ = 0;
};

}  // namespace gluray::present

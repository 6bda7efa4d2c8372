// During its lifetime, the program reads finished images if the bound read framebuffer shows unfinished
// images with light (adr/0054). Used by the generated stubs around glReadPixels; GL thread.
#pragma once
#include "gl/context/context.h"

namespace gluray::gl {

class FinishedRead {
 public:
  FinishedRead(Context& context, const scene::Region& region, GLenum format) noexcept : context_(context) {
    begin(region, format);
  }
  ~FinishedRead() {
    if (bound_) unbind();
  }
  FinishedRead(const FinishedRead&) = delete;
  FinishedRead& operator=(const FinishedRead&) = delete;

 private:
  void begin(const scene::Region& region, GLenum format) noexcept;
  void bind(const scene::Region& region) noexcept;
  void unbind() noexcept;

  Context& context_;
  bool bound_ = false;
};

}  // namespace gluray::gl

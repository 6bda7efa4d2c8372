// While it lives, a read of the bound read framebuffer gets finished pictures where that holds pictures with
// light that are not. Used by the generated stubs around commands that give the program pixels; GL thread.
#pragma once
#include "gl/context.h"

namespace gluray::gl {

class FinishedRead {
 public:
  FinishedRead(Context& context, const scene::Region& region, GLenum format) noexcept : context_(context) {
    if (context.shadow.settings.changesPicture()) [[unlikely]]
      bind(region, format);
  }
  ~FinishedRead() {
    if (bound_) unbind();
  }
  FinishedRead(const FinishedRead&) = delete;
  FinishedRead& operator=(const FinishedRead&) = delete;

 private:
  void bind(const scene::Region& region, GLenum format) noexcept;
  void unbind() noexcept;

  Context& context_;
  bool bound_ = false;
};

}  // namespace gluray::gl

// A read of colours by the program. A large one finishes the picture of the bound read framebuffer
// (adr/0095). If that shows images with light that still have noise, the program reads a copy without it
// during the lifetime of this object (adr/0054). Used by the generated stubs around glReadPixels; GL thread.
#pragma once
#include "gl/context/context.h"

namespace gluray::gl {

class FinishedRead {
 public:
  FinishedRead(Context& context, const scene::Region& region, GLenum format) noexcept
      : context_(context), region_(region) {
    begin(format);
  }
  ~FinishedRead() {
    if (isPicture_) [[unlikely]]
      pictureRead();
    if (bound_) unbind();
  }
  FinishedRead(const FinishedRead&) = delete;
  FinishedRead& operator=(const FinishedRead&) = delete;

 private:
  void begin(GLenum format) noexcept;
  void bind() noexcept;
  void unbind() noexcept;
  void pictureRead() noexcept;

  Context& context_;
  const scene::Region region_;
  bool bound_ = false, isPicture_ = false;
};

}  // namespace gluray::gl

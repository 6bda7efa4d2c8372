// Presents complete images of MPI programs: gathered images with ground and background, which the images of
// single ranks lack, and with antialiased edges where the ranks' parts meet (adr/0089). Implemented in
// intercept/present/. GL thread, context current.
#pragma once
#include "base/image.h"
#include "gl/real/real.h"
#include "scene/snapshot.h"

#include <GL/gl.h>

#include <cstdint>
#include <memory>

namespace gluray::gl {

/// The base class makes no complete images.
class CompletePresenter {
 public:
  virtual ~CompletePresenter() = default;
  /// Whether present() may make a complete image in addition to the image that it writes.
  virtual bool mayMake(const scene::Snapshot&) const noexcept { return false; }
  /// Requests a complete image of the next snapshot that is passed to present(). Without a request none is
  /// made.
  virtual void expect() noexcept {}
  /// The complete image of the snapshot that was presented after expect(); null if there is none.
  virtual std::shared_ptr<const Image> takeImage() noexcept { return nullptr; }
  enum class Copy : uint8_t { beforeDraw, afterDraw };
  /// Copies the bound draw framebuffer's colours and depths in `region`. Returns false if that is not
  /// possible. No error may be pending. Never throws.
  virtual bool keep(const RealGl&, const scene::Region& /*region*/, Copy) noexcept { return false; }
  /// Writes that copy back into the same framebuffer, which must be bound.
  virtual void putBack(const RealGl&, Copy) noexcept {}
  /// Merges a complete image into the bound framebuffer, as Presenter::present() does. Never throws.
  virtual bool write(const RealGl&, const Image&, const scene::Snapshot&, GLenum /*depthFunc*/) noexcept {
    return false;
  }
  /// Reports that a complete image was not shown, because the program does not compose its ranks' images
  /// here, or not in a recognised way.
  virtual void leaveOut(const scene::Snapshot&) noexcept {}
};

}  // namespace gluray::gl

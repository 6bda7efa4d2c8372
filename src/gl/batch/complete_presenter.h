// Presents complete images of MPI programs: gathered images with ground and background, which the ranks'
// own images lack, and with smooth edges at the ranks' borders (adr/0089). Implemented in
// intercept/present/. GL thread, context current.
#pragma once
#include "base/image.h"
#include "gl/real/real.h"
#include "scene/snapshot.h"

#include <GL/gl.h>

#include <cstdint>
#include <memory>

namespace gluray::gl {

/// The base class makes none.
class CompletePresenter {
 public:
  virtual ~CompletePresenter() = default;
  /// Whether present() may make a complete image beside the one of the snapshot that it writes.
  virtual bool mayMake(const scene::Snapshot&) const noexcept { return false; }
  /// present() shall make one of the snapshot that it gets next. Otherwise it makes none.
  virtual void expect() noexcept {}
  /// The complete image of the snapshot that was presented after expect(); null: there is none.
  virtual std::shared_ptr<const Image> takeImage() noexcept { return nullptr; }
  enum class Copy : uint8_t { beforeDraw, afterDraw };
  /// Keeps a copy of the bound draw framebuffer's colours and depths in `region`. False: it cannot. No error
  /// may be pending. Never throws.
  virtual bool keep(const RealGl&, const scene::Region& /*region*/, Copy) noexcept { return false; }
  /// Writes that copy back into the same framebuffer, which is bound.
  virtual void putBack(const RealGl&, Copy) noexcept {}
  /// Merges a complete image into the bound framebuffer, as Presenter::present() does. Never throws.
  virtual bool write(const RealGl&, const Image&, const scene::Snapshot&, GLenum /*depthFunc*/) noexcept {
    return false;
  }
  /// A complete image was not shown: the program does not compose its ranks' images here, or not in a way
  /// that is recognised.
  virtual void leaveOut(const scene::Snapshot&) noexcept {}
};

}  // namespace gluray::gl

// Shows images in a window without a swap: at once, or traced while the program prepares its next frame
// (frame lag). GL thread.
#pragma once
#include "gl/batch/window_presenter.h"
#include "intercept/present/presented_images.h"

namespace gluray::present {

class TracedWindow final : public gl::WindowPresenter {
 public:
  explicit TracedWindow(PresentedImages& shared) : shared_(shared) {}
  gl::PresentResult show(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                         const gl::ShowTarget& target) noexcept override;
  gl::LagRefusal traceAhead(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                            const gl::AheadTarget& target) noexcept override;
  void dropAhead() noexcept override;
  void refineWhileIdle(const gl::OpenIdleWindow& open) noexcept override;
  void stopRefining() noexcept override;
  bool knowsClear(const gl::ClearedTarget& cleared) const noexcept override;
  GLenum clear(const gl::RealGl& real, const gl::WindowClear& clear) noexcept override;

 private:
  PresentedImages& shared_;
};

}  // namespace gluray::present

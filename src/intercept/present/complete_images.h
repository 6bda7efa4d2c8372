// Makes and writes complete images of MPI programs, in addition to their ranks' images, before the other
// ranks receive these (adr/0089). One per context. GL thread.
#pragma once
#include "frame/images/traced_images.h"
#include "gl/batch/complete_presenter.h"
#include "intercept/present/kept_framebuffer.h"
#include "intercept/present/presented_images.h"

#include <memory>
#include <utility>

namespace gluray::present {

class CompleteImages final : public gl::CompletePresenter {
 public:
  /// `shared` need not be constructed yet.
  CompleteImages(const frame::Tracer& tracer, PresentedImages& shared);

  /// The tracer for images that are shown: makes complete ones before others hear of these.
  frame::Tracer tracer();

  bool mayMake(const scene::Snapshot& snapshot) const noexcept override;
  void expect() noexcept override { isExpected_ = true, made_.reset(); }
  std::shared_ptr<const Image> takeImage() noexcept override {
    isExpected_ = false;
    return std::exchange(made_, nullptr);
  }
  bool keep(const gl::RealGl& real, const scene::Region& region, Copy copy) noexcept override;
  void putBack(const gl::RealGl& real, Copy copy) noexcept override;
  bool write(const gl::RealGl& real, const Image& image, const scene::Snapshot& snapshot,
             GLenum depthFunc) noexcept override;
  void leaveOut(const scene::Snapshot& snapshot) noexcept override;

 private:
  void make(const scene::Snapshot& snapshot, const Image& shown, bool finished) noexcept;
  std::shared_ptr<const Image> traced(const scene::Snapshot& snapshot, bool finished);

  frame::Tracer tracer_;
  frame::TracedImages images_;
  PresentedImages& shared_;
  bool isExpected_ = false;
  std::shared_ptr<const Image> made_;
  KeptFramebuffer before_, after_;
  int unshown_ = 0;  // complete images with scenery since the last one that was shown
};

}  // namespace gluray::present

// Makes and writes complete pictures of MPI programs, in addition to their ranks' pictures, before the other
// ranks receive these (adr/0089). One per context. GL thread.
#pragma once
#include "frame/pictures/traced_pictures.h"
#include "gl/batch/complete_presenter.h"
#include "intercept/present/kept_framebuffer.h"
#include "intercept/present/presented_pictures.h"

#include <memory>
#include <utility>

namespace gluray::present {

class CompletePictures final : public gl::CompletePresenter {
 public:
  /// `shared` need not be constructed yet.
  CompletePictures(const frame::Tracer& tracer, PresentedPictures& shared);

  /// The tracer for pictures that are shown: makes complete ones before others hear of these.
  frame::Tracer tracer();

  bool mayMake(const scene::Snapshot& snapshot) const noexcept override;
  void expect() noexcept override { isExpected_ = true, made_.reset(); }
  std::shared_ptr<const Image> takePicture() noexcept override {
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
  frame::TracedPictures pictures_;
  PresentedPictures& shared_;
  bool isExpected_ = false;
  std::shared_ptr<const Image> made_;
  KeptFramebuffer before_, after_;
  int unshown_ = 0;  // complete pictures with scenery since the last one that was shown
};

}  // namespace gluray::present

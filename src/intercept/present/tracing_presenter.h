// Presents a finished batch: traces it and writes it back; if that fails, draws it with the real OpenGL. One
// per context. GL thread.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/present/buffer_reader.h"
#include "intercept/present/complete_images.h"
#include "intercept/present/presented_images.h"
#include "intercept/present/reused_captures.h"
#include "intercept/present/traced_layers.h"
#include "intercept/present/traced_volumes.h"
#include "intercept/present/traced_window.h"
#include "intercept/present/write_back/texture_upload.h"
#include "scene/replaced_pixels.h"

#include <string>
#include <utility>
#include <vector>

namespace gluray::present {

class TracingPresenter final : public gl::Presenter {
 public:
  explicit TracingPresenter(const frame::Tracer& tracer, Written onWritten = {})
      : complete_(tracer, shared_),
        shared_(complete_.tracer(), std::move(onWritten)),
        layers_(shared_),
        window_(shared_),
        volumes_(shared_),
        reader_(shared_) {}

  bool supports(const gl::RealGl& real, bool, std::string& why) noexcept override {
    return shared_.supported(real, why);
  }
  gl::PresentResult present(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                            const gl::PresentTarget& target) noexcept override;
  gl::PresentResult resolve(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                            const gl::ResolveTarget& target) noexcept override;
  gl::PresentResult relight(const gl::RealGl& real, const scene::SnapshotPtr& before,
                            const scene::SnapshotPtr& now, const gl::RelightTarget& target) noexcept override;
  bool antialias(const gl::RealGl& real, const scene::Fxaa& fxaa, GLint unit, GLuint target,
                 const scene::Region& region, const Settings& settings) noexcept override;
  bool lightsVolumes() const noexcept override { return shared_.tracer.illuminate != nullptr; }
  bool castVolume(const gl::RealGl& real, const scene::VolumeCast& cast, std::string& why) noexcept override {
    return volumes_.cast(real, cast, why);
  }
  gl::LayerPresenter& layers() noexcept override { return layers_; }
  gl::WindowPresenter& window() noexcept override { return window_; }
  gl::FramebufferReader& reader() noexcept override { return reader_; }
  gl::CompletePresenter& complete() noexcept override { return complete_; }
  gl::SharedNames takeNames() override { return shared_.takeNames(); }
  void forget(const gl::RealGl&) noexcept override { shared_.forget(); }

 private:
  gl::PresentResult tracedOrRasterised(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                                       const gl::PresentTarget& target);
  scene::SnapshotPtr withDepths(const gl::RealGl& real, const scene::SnapshotPtr& catchers,
                                PendingErrors& pending);
  enum class Way { none, uploaded, drawn };
  /// Writes an image into the framebuffer, and returns how; none, with the reason, if that fails.
  Way write(const gl::RealGl& real, const frame::ImageCache::CachedImage& cached,
            const scene::Snapshot& snapshot, const gl::PresentTarget& target, PendingErrors& pending,
            std::string& why) noexcept;
  bool writeSeen(const gl::RealGl& real, const Image& image, const scene::Snapshot& snapshot,
                 WriteBackTarget into, PendingErrors& pending);
  gl::PresentResult relit(const gl::RealGl& real, const scene::SnapshotPtr& before,
                          const scene::SnapshotPtr& now, const gl::RelightTarget& target);
  bool readShown(const gl::RealGl& real, const Image& written, bool layers, scene::ShownPixels& shown);
  gl::PresentResult resolved(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                             const gl::ResolveTarget& target);

  CompleteImages complete_;
  PresentedImages shared_;
  TracedLayers layers_;
  TracedWindow window_;
  TracedVolumes volumes_;
  BufferReader reader_;
  TextureUpload put_;
  ClearedColor clearedObject_;
  struct Pixels {
    uint64_t of = 0;  // id of the image; 0: none
    scene::Resolve how;
    Image image;
  };
  Pixels pixels_;  // the last ones: a program may resolve colours and depths separately
  std::vector<uint32_t> before_, after_;  // of anti-aliasing; reused memory
  // Of catchers: the framebuffer's depths; what they take from visible pixels, as opacities, or as the image
  // without hidden pixels. Reused memory.
  ReusedCaptures depths_;
  TakenLight taken_;
  Image seen_;
  Image replaced_;  // of relight(); reused memory
};

}  // namespace gluray::present

// What happens to a finished batch: it is traced and written back; failing that, the real OpenGL draws it.
// One per context. GL thread.
#pragma once
#include "gl/presenter.h"
#include "intercept/present/cleared_color.h"
#include "intercept/present/last_pictures.h"
#include "intercept/present/texture_put.h"
#include "intercept/present/trace_ahead.h"
#include "intercept/present/write_back.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>

namespace gluray::present {

/// Told of every picture that has just been written into the bound framebuffer.
using Written = std::function<void(const gl::RealGl&, const Image&)>;

class TracingPresenter final : public gl::Presenter {
 public:
  explicit TracingPresenter(Tracer tracer, Written onWritten = {})
      : tracer_(std::move(tracer)), onWritten_(std::move(onWritten)) {}

  gl::PresentResult present(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                            const gl::PresentTarget& target) noexcept override;
  gl::PresentResult presentLayers(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                                  const gl::LayersTarget& target, bool rasterise) noexcept override;
  gl::PresentResult traceLayers(const scene::SnapshotPtr& snapshot,
                                const gl::LayersTarget& target) noexcept override;
  gl::PresentResult show(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                         const gl::ShowTarget& target) noexcept override;
  gl::PresentResult resolve(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                            const gl::ResolveTarget& target) noexcept override;
  bool countPixels(const gl::RealGl& real, const gl::HeldPass& pass, GLuint texture, glm::ivec2 size,
                   uint64_t pixels) noexcept override;
  bool readDepths(const gl::RealGl& real, GLint unit, glm::ivec2 size,
                  std::vector<glm::vec2>& out) noexcept override;
  bool supports(const gl::RealGl& real, bool core, std::string& why) noexcept override;
  bool antialias(const gl::RealGl& real, const scene::Fxaa& fxaa, GLint unit, GLuint target,
                 const scene::Region& region, const Settings& settings) noexcept override;
  bool readDepth(const gl::RealGl& real, const scene::Region& region,
                 std::vector<float>& out) noexcept override;
  bool readColors(const gl::RealGl& real, const scene::Region& region,
                  std::vector<uint32_t>& out) noexcept override;
  gl::LagRefusal traceAhead(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                            const gl::AheadTarget& target) noexcept override;
  void dropAhead() noexcept override;
  GLenum clear(const gl::RealGl& real, const gl::WindowClear& clear) noexcept override;
  gl::SharedNames takeNames() override;
  void forget(const gl::RealGl& real) noexcept override;

 private:
  gl::PresentResult tracedOrRasterised(const gl::RealGl& real, const scene::Snapshot& snapshot,
                                       const gl::PresentTarget& target);
  gl::PresentResult tracedOrRasterised(const gl::RealGl& real, const scene::Snapshot* snapshot,
                                       const gl::LayersTarget& target);
  /// Writes a picture into the framebuffer. False, with the reason, where it could not be.
  bool written(const gl::RealGl& real, const LastPictures::Picture& picture, const scene::Snapshot& snapshot,
               const gl::PresentTarget& target, PendingErrors& pending, std::string& why) noexcept;

  Tracer tracer_;
  Written onWritten_;
  gl::PresentResult resolved(const gl::RealGl& real, const scene::Snapshot& snapshot,
                             const gl::ResolveTarget& target);
  struct Pixels {
    uint64_t of = 0;  // number of the picture; 0: none
    scene::Resolve how;
    Image image;
  };
  Pixels pixels_;                         // made last: a program may want its colours and its depths in turn
  std::vector<uint32_t> before_, after_;  // of anti-aliasing; memory is kept
  WriteBack& writeBack(const gl::RealGl& real, Image::Content content);
  std::array<std::unique_ptr<WriteBack>, 3> writeBacks_;  // by what images hold
  TexturePut put_;
  ClearedColor clearedWindow_, clearedObject_;
  bool readPixels(const gl::RealGl& real, const scene::Region& region, GLenum format, GLenum type,
                  void* out) noexcept;
  const Features& features(const gl::RealGl& real);
  std::optional<Features> features_;  // of the context
  /// The picture of the snapshot, traced or known already, with misses in `missColor` where one is given;
  /// null where tracing fails, with `why`.
  const LastPictures::Picture* pictureOf(const scene::Snapshot& snapshot, bool mayRepeat,
                                         std::optional<uint32_t> missColor, gl::PresentResult& result,
                                         std::string& why);
  LastPictures pictures_;
  std::unique_ptr<TraceAhead> ahead_;  // where frames lag
};

}  // namespace gluray::present

// Reads depths and colours of the bound draw framebuffer, and finishes images that the program reads. GL
// thread, context current; restores all state.
#pragma once
#include "gl/batch/framebuffer_reader.h"
#include "intercept/present/finished_framebuffer.h"
#include "intercept/present/kept_framebuffer.h"
#include "intercept/present/presented_images.h"
#include "intercept/present/read_back/blending_trial.h"

#include <cstdint>
#include <vector>

namespace gluray::present {

class BufferReader final : public gl::FramebufferReader {
 public:
  explicit BufferReader(PresentedImages& shared) : shared_(shared) {}
  bool readDepth(const gl::RealGl& real, const scene::Region& region,
                 std::vector<float>& out) noexcept override;
  bool readColors(const gl::RealGl& real, const scene::Region& region,
                  std::vector<uint32_t>& out) noexcept override;
  bool readFloatColors(const gl::RealGl& real, const scene::Region& region,
                       std::vector<glm::vec4>& out) noexcept override;
  bool readResolved(const gl::RealGl& real, const scene::Region& region,
                    std::vector<uint32_t>& out) noexcept override;
  bool readFarthest(const gl::RealGl& real, const scene::Region& region, bool least,
                    std::vector<float>& out) noexcept override;
  bool readSamples(const gl::RealGl& real, const scene::Region& region,
                   std::vector<uint32_t>& out) noexcept override;
  bool bindCopy(const gl::RealGl& real, const scene::Region& region, bool colors) noexcept override;
  void unbindCopy(const gl::RealGl& real) noexcept override { shared_.samples.unbindCopy(real); }
  bool keep(const gl::RealGl& real, const scene::Region& region) noexcept override;
  void putBack(const gl::RealGl& real) noexcept override;
  bool replacesColors(const gl::RealGl& real) noexcept override;
  std::optional<glm::vec2> pointCoordinateShift(const gl::RealGl& real, int samples) noexcept override;
  gl::PresentResult bindFinished(const gl::RealGl& real, const scene::Region& region) noexcept override;
  void unbindFinished(const gl::RealGl& real) noexcept override {
    finished_.unbind(real, shared_.features(real));
  }

 private:
  bool read(const gl::RealGl& real, const scene::Region& region, GLenum format, GLenum type,
            void* out) noexcept;

  PresentedImages& shared_;
  FinishedFramebuffer finished_;
  KeptFramebuffer kept_;
  BlendingTrial blending_;
};

}  // namespace gluray::present

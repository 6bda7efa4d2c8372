// Reads depths and colours of the bound draw framebuffer. GL thread, context current; restores all state.
#pragma once
#include "gl/batch/framebuffer_reader.h"
#include "intercept/present/presented_pictures.h"

#include <cstdint>
#include <vector>

namespace gluray::present {

class BufferReader final : public gl::FramebufferReader {
 public:
  explicit BufferReader(PresentedPictures& shared) : shared_(shared) {}
  bool readDepth(const gl::RealGl& real, const scene::Region& region,
                 std::vector<float>& out) noexcept override;
  bool readColors(const gl::RealGl& real, const scene::Region& region,
                  std::vector<uint32_t>& out) noexcept override;

 private:
  bool read(const gl::RealGl& real, const scene::Region& region, GLenum format, GLenum type,
            void* out) noexcept;

  PresentedPictures& shared_;
};

}  // namespace gluray::present

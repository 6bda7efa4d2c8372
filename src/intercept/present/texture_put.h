// A traced picture sent straight into the textures of a framebuffer object that holds nothing but what it was
// cleared to: nothing is drawn. GL thread, context current, outside glBegin/glEnd.
#pragma once
#include "base/image.h"
#include "gl/presenter.h"
#include "intercept/present/features.h"
#include "intercept/present/hit_bands.h"
#include "intercept/present/state_guard.h"

#include <array>
#include <optional>
#include <vector>

namespace gluray::present {

/// Depth as a buffer of 24 bits holds it: rounded as llvmpipe does, whose product is a float.
uint32_t depth24(float depth);

class TexturePut {
 public:
  /// Puts the image into the bound draw framebuffer's textures, as WriteBack::write() would have drawn it
  /// with GL_LEQUAL over what `cleared` says. False where textures are of other kinds, or something went
  /// wrong: then what was put so far may be drawn over. Errors that were pending are moved to `pending`. No
  /// state that the program can query differs afterwards.
  bool put(const gl::RealGl& real, const Features& features, const Image& image,
           const gl::ClearedTarget& cleared, PendingErrors& pending);

 private:
  struct Attached {
    GLuint color = 0, depth = 0;  // textures
    GLenum colorBuffer = 0;
    GLenum depthFormat = 0;  // GL_DEPTH24_STENCIL8 or GL_DEPTH_COMPONENT32F
  };
  std::optional<Attached> attached(const gl::RealGl& real, StateGuard& guard, const Features& features,
                                   const Image& image) const;
  uint32_t bitsOf(const gl::RealGl& real, StateGuard& guard, const Attached& to,
                  const gl::ClearedTarget& cleared);
  /// A band of the picture, and where its pixels begin in what is sent.
  struct Part {
    Band band;
    size_t first = 0;
  };
  void findParts(const Image& image);
  void fill(const Image& image, const Part& part, uint32_t background, bool floats);
  void send(const gl::RealGl& real, const Features& features, const Image& image, const Part& part,
            bool floats) const;

  std::vector<Part> parts_;
  std::vector<uint32_t> colors_, depths_;      // of all parts; memory is kept
  std::optional<std::array<float, 4>> color_;  // that was last cleared to
  uint32_t bits_ = 0;                          // and what framebuffers of RGBA8 hold of it
};

}  // namespace gluray::present

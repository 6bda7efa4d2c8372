// An OpenGL context that draws into memory: the real OpenGL of tests, without any window system.
#pragma once
#include "gl/real/real.h"

#include <cstdint>
#include <memory>
#include <ostream>
#include <vector>

namespace gluray::test {

struct ContextWish {
  int width = 64, height = 64;  // pixels
  bool core = false;            // core profile; otherwise compatibility
  int major = 0, minor = 0;     // 0: the highest available
};

/// How test frameworks print one.
inline void PrintTo(const ContextWish& wish, std::ostream* out) {
  *out << (wish.core ? "core " : "compatibility ") << wish.major << '.' << wish.minor;
}

/// An OSMesa context: RGBA8 colour (single-buffered), 24 bit depth, 8 bit stencil. Current in the creating
/// thread.
class OsmesaContext {
 public:
  /// Null if OSMesa cannot make such a context. It shares objects with `share`, which is of the same kind.
  static std::unique_ptr<OsmesaContext> create(const ContextWish& wish = {},
                                               const OsmesaContext* share = nullptr);
  ~OsmesaContext();

  bool makeCurrent();
  const gl::RealGl& real() const { return real_; }
  int width() const { return wish_.width; }
  int height() const { return wish_.height; }

  /// RGBA8, bottom row first, width*height pixels, of the framebuffer that is bound for reading.
  std::vector<uint32_t> colors() const;
  /// Window depth, bottom row first.
  std::vector<float> depths() const;

 private:
  OsmesaContext() = default;
  ContextWish wish_;
  void* context_ = nullptr;  // OSMesaContext
  std::vector<uint32_t> buffer_;
  gl::RealGl real_;
};

}  // namespace gluray::test

// Reads the samples of the program's multisampled framebuffer with shaders of the real OpenGL. One per
// context. GL thread, context current; restores all state.
#pragma once
#include "gl/batch/presenter.h"
#include "gl/real/real.h"
#include "intercept/present/read_back/sample_copy.h"
#include "intercept/present/state/features.h"
#include "scene/snapshot.h"

#include <GL/gl.h>

#include <cstdint>
#include <vector>

namespace gluray::present {

class SampleDepths {
 public:
  /// FramebufferReader::readFarthest(). `out` has room for the pixels of the region.
  bool readFarthest(const gl::RealGl& real, const Features& features, const scene::Region& region, bool least,
                    float* out);
  /// FramebufferReader::readResolved(). `out` has room for the pixels of the region.
  bool resolve(const gl::RealGl& real, const Features& features, const scene::Region& region, uint32_t* out);
  /// FramebufferReader::readSamples().
  bool readAll(const gl::RealGl& real, const Features& features, const scene::Region& region,
               std::vector<uint32_t>& out);

  /// FramebufferReader::bindCopy() and unbindCopy().
  bool bindCopy(const gl::RealGl& real, const Features& features, const scene::Region& region, bool colors);
  void unbindCopy(const gl::RealGl& real);

  /// Releases ownership of our names in the share group, and returns them.
  gl::SharedNames takeNames();

 private:
  /// A texture of floats that is drawn into, see grownSize().
  struct Target {
    GLuint texture = 0;
    glm::ivec2 size = {0, 0};  // texels
  };
  /// Samples [first, end) of a pixel, of which the largest or the smallest depth is wanted.
  struct Range {
    int first = 0, end = 1;
    bool least = false;
    glm::ivec2 at = {0, 0};  // the region's lower left pixel
  };
  /// What is drawn into instead of the program's framebuffer.
  struct Stage {
    GLuint framebuffer = 0, colors = 0;
    GLint program = 0;  // the program's framebuffer
    SampleCopy depths;
  };
  bool copy(const gl::RealGl& real, const Features& features, const scene::Region& region);
  bool ready(const gl::RealGl& real, const Features& features);
  bool reduce(const gl::RealGl& real, const Features& features, const scene::Region& region,
              const SampleCopy& from, const Range& range, void* out);
  void attachColors(const gl::RealGl& real, GLint samples);
  static bool resolveColors(const gl::RealGl& real, const Features& features, const scene::Region& region,
                            void* out);

  GLuint program_ = 0, vertexArray_ = 0;
  bool impossible_ = false;
  SampleCopy copy_;
  Target target_;
  Stage stage_;
};

}  // namespace gluray::present

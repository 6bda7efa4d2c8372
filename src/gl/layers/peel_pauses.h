// How long peels are left to the real OpenGL after they could not be traced. A pause belongs to one kind of
// depth pass, so that passes of other views or surfaces are held back at once. Owned by Peeling, GL thread.
#pragma once
#include <GL/gl.h>
#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::gl {

class PeelPauses {
 public:
  /// What tells depth passes apart: their target and their first draw.
  struct Pass {
    GLuint framebuffer = 0;
    glm::ivec4 viewport{0};
    GLenum mode = 0;
    bool label = false;  // the draw shows at most one quad
    bool operator==(const Pass&) const = default;
  };

  /// Whether a pass that begins with this draw may be held back. Call for each draw of a depth pass of which
  /// nothing is held back. `frame`: number of the current frame.
  bool mayBegin(const Pass& pass, uint64_t frame);
  /// Reports that depths are cleared or peels drawn: the next draw of a depth pass is its first.
  void endPass() noexcept { inPass_ = false; }
  /// Reports that the held pass that began with `pass` had to be rasterised: nothing of it is held back for a
  /// number of passes that doubles each time. `labels`: it drew only labels.
  void failed(const Pass& pass, bool labels);
  /// Reports that the pass was traced.
  void succeeded(const Pass& pass) noexcept;

 private:
  struct Pause {
    Pass pass;
    size_t length = 1;    // of the next pause, passes
    size_t left = 0;      // passes left in this pause
    bool labels = false;  // only labels were drawn
  };
  static constexpr size_t kLongest = 256, kMost = 8;
  Pause* find(const Pass& pass) noexcept;

  std::vector<Pause> pauses_;
  bool inPass_ = false;     // draws of the current depth pass were left to the real OpenGL
  bool ofLabels_ = false;   // because the pass drew only labels before
  Pass first_;              // of the current depth pass
  uint64_t passFrame_ = 0;  // frame in which it began
};

}  // namespace gluray::gl

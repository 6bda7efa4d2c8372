// Captures the positions of a draw for any vertex shader: the real OpenGL runs the shader, and transform
// feedback captures gl_Position. One per shader program. GL thread, context current.
#pragma once
#include "gl/culled/feedback/program_copy.h"
#include "gl/real/elements.h"
#include "gl/real/real.h"

#include <GL/gl.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace gluray::gl {

class PositionFeedback {
 public:
  static constexpr size_t kStride = 4 * sizeof(float);  // bytes of a position

  explicit PositionFeedback(const Program& original) : original_(original) {}

  /// Whether positions can be captured. The first call links a copy of the shader program. No error may be
  /// pending.
  bool works(const RealGl& real);
  /// Whether this many positions fit into a buffer.
  static bool isPossible(uint32_t first, uint32_t end, uint32_t instances);
  /// Calls `take` with the clip coordinates of vertices `first` to `end` - 1, four floats each, for a draw
  /// with the current state and the instances of `as`, instance by instance. Returns false on failure.
  /// Changes no state. No error may be pending.
  bool capture(const RealGl& real, uint32_t first, uint32_t end, const Elements& as,
               const std::function<void(const std::byte*)>& take);
  /// Deletes its objects.
  void release(const RealGl& real);

 private:
  bool draw(const RealGl& real, uint32_t first, uint32_t count, const Elements& as);

  const Program& original_;
  std::optional<ProgramCopy> copy_;
  GLuint feedback_ = 0, buffer_ = 0;
  GLsizeiptr size_ = 0;  // bytes of the buffer
};

}  // namespace gluray::gl

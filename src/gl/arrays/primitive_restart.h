// Primitive restart: the index at which a draw begins new primitives. GL thread.
#pragma once
#include "gl/real/elements.h"
#include "gl/real/real.h"

#include <GL/gl.h>

#include <cstdint>
#include <optional>
#include <unordered_map>

namespace gluray::gl {

class Buffer;

struct PrimitiveRestart {
  bool atLargest = false;      // GL_PRIMITIVE_RESTART_FIXED_INDEX: the largest index of the type
  std::optional<uint32_t> at;  // GL_PRIMITIVE_RESTART: this one, unless `atLargest`
  bool byExtension = false;    // GL_PRIMITIVE_RESTART_NV: any index may be the one

  bool isOn() const { return atLargest || at || byExtension; }
  /// The index of `type` that restarts, before the base vertex is added; none if no such index does. Draws
  /// without indices, of type 0, are never restarted.
  std::optional<uint32_t> indexOf(GLenum type) const;
  bool operator==(const PrimitiveRestart&) const = default;
};

/// Reads the state back from the real OpenGL.
PrimitiveRestart readRestart(const RealGl& real);

/// Which draws name the index that restarts. Many programs switch primitive restart on and never use it. What
/// lies in buffers is searched once for each version.
class RestartedDraws {
 public:
  /// Whether the draw names the index, or may name it. `buffer`: bound to GL_ELEMENT_ARRAY_BUFFER, or null.
  bool isRestarted(const RealGl& real, const PrimitiveRestart& restart, Buffer* buffer,
                   const Elements& elements) {
    return elements.type && restart.isOn() && search(real, restart, buffer, elements);
  }

 private:
  bool search(const RealGl& real, const PrimitiveRestart& restart, Buffer* buffer, const Elements& elements);

  std::unordered_map<uint64_t, bool> known_;  // by a hash of buffer, version, range and index
};

}  // namespace gluray::gl

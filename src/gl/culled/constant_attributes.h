// Tests whether components of vertex attributes are 1 at all vertices of a draw. A part of CulledDraws, GL
// thread, context current.
#pragma once
#include "base/hash.h"
#include "gl/culled/shader_slice/position_slice.h"
#include "gl/glsl/program.h"
#include "gl/real/elements.h"
#include "gl/shadow/shadow_state.h"

#include <span>
#include <unordered_map>

namespace gluray::gl {

class ConstantAttributes {
 public:
  /// Tests the attributes of draws by `program`: their arrays, or the current value of attributes without
  /// array. Caches results by content. Returns false if some are not 1 or cannot be read.
  bool areOnes(ShadowState& shadow, const Program& program, std::span<const AttributeComponent> components,
               GLenum mode, const Elements& elements);

 private:
  bool isOne(ShadowState& shadow, const Program& program, const AttributeComponent& component, GLenum mode,
             const Elements& elements);
  bool isOne(ShadowState& shadow, const ArraySource& array, int component, GLenum mode,
             const Elements& elements);

  std::unordered_map<Hash128, bool> known_;
};

}  // namespace gluray::gl

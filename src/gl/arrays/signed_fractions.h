// How the real OpenGL converts signed integers in vertex arrays to fractions, such as normals of bytes: by GL
// 2.1, table 2.9, or by GL 4.2, equation 2.2. A part of ShadowState, GL thread, context current.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/real/real.h"

#include <optional>

namespace gluray::gl {

class SignedFractions {
 public:
  /// Whether c / (2^(b-1) - 1), GL 4.2's equation 2.2, converts all signed bytes and shorts except the lowest
  /// value. Versions and drivers of OpenGL differ, so the first call finds out by a draw. Nullopt if this
  /// OpenGL lacks what the draw needs, or the program's own transform feedback is active. No error may be
  /// pending.
  std::optional<bool> areSymmetric(const RealGl& real, bool core);
  /// Sets ArraySource::symmetric of the arrays that contain such integers, if the rule can be determined.
  /// Returns whether it made a draw.
  bool apply(const RealGl& real, bool core, ArrayState& arrays);

 private:
  bool tried_ = false;
  std::optional<bool> symmetric_;
};

}  // namespace gluray::gl

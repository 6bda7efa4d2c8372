// How the real OpenGL converts signed integers in vertex arrays that stand for fractions, such as normals of
// bytes: by GL 2.1, table 2.9, or by GL 4.2, equation 2.2. A part of ShadowState, GL thread, context current.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/real/real.h"

#include <optional>

namespace gluray::gl {

class SignedFractions {
 public:
  /// Versions and drivers of OpenGL differ. Found out by a draw when first asked: whether all signed bytes
  /// and shorts but the lowest ones are c / (2^(b-1) - 1), GL 4.2's equation 2.2. Nothing if this OpenGL
  /// lacks what the draw takes, or the program's own transform feedback is active. No error may be pending.
  std::optional<bool> areSymmetric(const RealGl& real, bool core);
  /// Sets ArraySource::symmetric of the arrays that hold such integers, if the rule can be found out. Returns
  /// whether it drew.
  bool apply(const RealGl& real, bool core, ArrayState& arrays);

 private:
  bool tried_ = false;
  std::optional<bool> symmetric_;
};

}  // namespace gluray::gl

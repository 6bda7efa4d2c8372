// Tests whether the real OpenGL converts signed normalised integers of vertex arrays like ArrayReader. A part
// of CulledDraws, GL thread, context current.
#pragma once
#include "gl/real/real.h"

#include <optional>

namespace gluray::gl {

class SignedFractions {
 public:
  /// Whether all signed bytes and shorts except the lowest are converted to c / (2^(b-1) - 1), GL 4.2's
  /// equation 2.2. Versions and drivers of OpenGL differ, so the first call tests it by a draw. No error may
  /// be pending.
  bool areSymmetric(const RealGl& real, bool core);

 private:
  std::optional<bool> symmetric_;
};

}  // namespace gluray::gl

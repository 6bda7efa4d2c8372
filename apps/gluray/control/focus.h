// Where a point of a window's picture lies in a view, for camera.focus-x and camera.focus-y. Pure; any
// thread.
#pragma once
#include <algorithm>
#include <vector>

namespace gluray::launcher {

struct FocusPosition {
  double x = 0, y = 0;  // shares of the view's width and height, from its lower left corner
};

/// `x`, `y` in pixels from the top left of a picture of `height` pixels; `viewport`: x, y from the bottom,
/// width and height, above 0, of the view in it.
inline FocusPosition focusPosition(double x, double y, int height, const std::vector<double>& viewport) {
  return {std::clamp((x - viewport[0]) / viewport[2], 0.0, 1.0),
          std::clamp((height - y - viewport[1]) / viewport[3], 0.0, 1.0)};
}

}  // namespace gluray::launcher

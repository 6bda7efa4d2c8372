// The work in a frame, and when two frames are of one kind (adr/0012). Calls no OpenGL. Any thread.
#pragma once
#include <algorithm>

namespace gluray::gl {

struct FrameLoad {
  double triangles = 0;  // of surfaces
  double pixels = 0;     // sum over the depth epochs of the largest viewport's pixels
  bool operator==(const FrameLoad&) const = default;
};

/// Whether triangles and pixels of both differ by no more than `factor`.
inline bool within(const FrameLoad& a, const FrameLoad& b, double factor) {
  const auto ratio = [](double one, double two) {
    return (std::max(one, two) + 1) / (std::min(one, two) + 1);
  };
  // Below some thousand triangles their number hardly affects the time.
  constexpr double kFew = 2000;
  return ratio(std::max(a.triangles, kFew), std::max(b.triangles, kFew)) <= factor &&
         ratio(a.pixels, b.pixels) <= factor;
}

inline FrameLoad largest(const FrameLoad& a, const FrameLoad& b) {
  return {std::max(a.triangles, b.triangles), std::max(a.pixels, b.pixels)};
}

}  // namespace gluray::gl

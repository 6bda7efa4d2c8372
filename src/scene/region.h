// A rectangle of pixels.
#pragma once

namespace gluray::scene {

/// The rectangle of pixels to trace: viewport, scissor and framebuffer intersected. Never empty in a
/// snapshot.
struct Region {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Region&) const = default;
};

}  // namespace gluray::scene

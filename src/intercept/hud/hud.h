// The overlay of `--hud`: frames per second, triangles, and how they are drawn, in the window's lower left
// corner. One per context, on its GL thread.
#pragma once
#include "gl/basics/statistics.h"
#include "gl/sharing/share_group.h"
#include "intercept/present/write_back/write_back.h"

#include <optional>
#include <string>
#include <vector>

namespace gluray::intercept {

/// Statistics of an interval.
struct HudFigures {
  double seconds = 0;
  uint64_t frames = 0, framesPassedThrough = 0;  // shown; passed through among them
  uint64_t traced = 0, rasterised = 0;           // triangles
  uint64_t flushes = 0, repeated = 0;            // images, and repeated ones among them
  uint64_t bvhBytes = 0;                         // of all acceleration structures now
  uint64_t lightPasses = 0;                      // passes that refined images
  double lightNoise = 0;                         // noise of the last refined image; 0: unknown
  bool refining = false;                         // a better acceleration structure is being built
};

/// The difference of two states of all contexts' statistics that are `seconds` apart.
HudFigures between(const gl::Statistics& before, const gl::Statistics& now, double seconds);

/// The lines of the overlay. Without frames: only "GLURAY".
std::vector<std::string> hudLines(const HudFigures& figures);

class Hud {
 public:
  explicit Hud(const gl::RealGl& real) : writeBack_(real) {}

  /// Draws over the finished frame in the back buffer, just before it is shown. `now`: totals of all
  /// contexts; `seconds`: time on any clock. Preserves depth and all queryable state. Returns the program's
  /// pending GL error, if any.
  GLenum draw(const gl::Statistics& now, double seconds);
  gl::SharedNames takeNames() { return writeBack_.takeNames(); }

 private:
  present::WriteBack writeBack_;
  std::optional<gl::Statistics> since_;
  double sinceSeconds_ = 0, lastSeconds_ = 0;
  std::vector<std::string> lines_;
  Image image_;
  uint64_t imageId_ = 0;
};

}  // namespace gluray::intercept

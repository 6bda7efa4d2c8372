// `--hud`: frames a second, triangles and what is done with them, in the lower left corner of the window. One
// per context; its GL thread.
#pragma once
#include "gl/share_group.h"
#include "gl/statistics.h"
#include "intercept/present/write_back/write_back.h"

#include <optional>
#include <string>
#include <vector>

namespace gluray::intercept {

/// What happened between two moments.
struct HudFigures {
  double seconds = 0;
  uint64_t frames = 0, framesPassedThrough = 0;  // shown; of them left to the real OpenGL as they came
  uint64_t traced = 0, rasterised = 0;           // triangles
  uint64_t flushes = 0, repeated = 0;            // pictures; of them those in which nothing had changed
  uint64_t bvhBytes = 0;                         // of all acceleration structures, now
  bool refining = false;                         // a better one is being built
};

/// The figures between two states of all contexts' statistics, `seconds` apart.
HudFigures between(const gl::Statistics& before, const gl::Statistics& now, double seconds);

/// What the corner says of them. No frames: that GLuRay is there.
std::vector<std::string> hudLines(const HudFigures& figures);

class Hud {
 public:
  explicit Hud(const gl::RealGl& real) : writeBack_(real) {}

  /// Draws over the finished frame in the back buffer, just before it is shown. `now` are the sums over all
  /// contexts, `seconds` any clock. No state that the program can query differs afterwards, and no depth. The
  /// error that was pending, if any, which is the program's.
  GLenum draw(const gl::Statistics& now, double seconds);
  gl::SharedNames takeNames() { return writeBack_.takeNames(); }

 private:
  present::WriteBack writeBack_;
  std::optional<gl::Statistics> since_;
  double sinceSeconds_ = 0, lastSeconds_ = 0;
  std::vector<std::string> lines_;
  Image image_;
  uint64_t picture_ = 0;
};

}  // namespace gluray::intercept

// The possible fates of a draw. ARCHITECTURE.md describes when each is chosen, and who draws the pixels.
#pragma once
#include <cstdint>

namespace gluray::gl {

enum class Fate : uint8_t {
  refused,        // an error
  undefined,      // its first vertex lies before the array: nothing is drawn
  recorded,       // into the display list being compiled
  recordedBelow,  // into a display list of the real OpenGL
  empty,          // no vertices: the real OpenGL checks for errors
  passedThrough,  // in a passthrough frame
  untraced,       // by a program that is never traced
  joinedRun,      // its vertices join a run of glBegin and glEnd
  heldPass,       // a pass before peels, held back
  heldPeel,       // a later peel, held back
  leftOutPass,    // a pass that draws nothing, because its layers are traced
  traced,         // with the batch
  replaced,       // a full-screen pass or a volume that GLuRay draws instead
  culled,         // rasterised without hidden parts
  rasterised,     // by the real OpenGL
};

}  // namespace gluray::gl

// What becomes of a draw: ARCHITECTURE.md says for each fate when it is chosen, and who draws the pixels.
#pragma once
#include <cstdint>
#include <string_view>

namespace gluray::gl {

#define GLURAY_FATES(X)                                                      \
  X(refused, "an error")                                                     \
  X(empty, "no vertices: the real OpenGL looks for errors")                  \
  X(undefined, "vertices before the array: nothing is drawn")                \
  X(recorded, "kept by the display list that is compiled")                   \
  X(recordedBelow, "kept by a display list of the real OpenGL")              \
  X(passedThrough, "in a passthrough frame")                                 \
  X(joinedRun, "small: its vertices join a run of glBegin and glEnd")        \
  X(heldPass, "a pass before peels, held back")                              \
  X(heldPeel, "a later peel, held back")                                     \
  X(leftOutPass, "a pass that draws nothing, because its layers are traced") \
  X(traced, "traced with the batch")                                         \
  X(replaced, "a full-screen pass that is made in its place")                \
  X(untraced, "by a program that is never traced")                           \
  X(culled, "rasterised without what cannot be seen")                        \
  X(rasterised, "rasterised")

enum class Fate : uint8_t {
#define X(name, text) name,
  GLURAY_FATES(X)
#undef X
};

/// The fate in plain words.
constexpr std::string_view describe(Fate fate) {
  constexpr std::string_view texts[] = {
#define X(name, text) text,
      GLURAY_FATES(X)
#undef X
  };
  return texts[static_cast<int>(fate)];
}

}  // namespace gluray::gl

// Plays one stream to the real OpenGL and through GLuRay: the results must be equal, and nothing may crash.
#pragma once
#include "tests/fuzz/comparison.h"
#include "tests/fuzz/stream.h"

#include <string>

namespace gluray::fuzz {

/// Plays the stream to both. `state`: compares all queryable state at the end, too. `ours`: GLuRay plays.
Outcome play(const Stream& stream, bool state, bool& ours);

/// How many draws of a stream were traced and rasterised.
struct Drawn {
  uint64_t traced = 0, byPrograms = 0, rasterised = 0;  // byPrograms: of those traced
};

/// Plays the stream through GLuRay only, over an OpenGL that draws nothing: nothing may crash.
Drawn playAlone(const Stream& stream);

/// The calls with their arguments, one a line.
std::string describe(const Stream& stream, bool alone);

}  // namespace gluray::fuzz

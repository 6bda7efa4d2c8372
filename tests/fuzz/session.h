// One stream, played to a plain OpenGL and to ours: the answers must be the same, and nothing may break.
#pragma once
#include "tests/fuzz/comparison.h"
#include "tests/fuzz/stream.h"

#include <string>

namespace gluray::fuzz {

/// Plays the stream to both. `state`: all queryable state is compared at the end, too. `ours` is set while
/// ours plays.
Outcome play(const Stream& stream, bool state, bool& ours);

/// What became of the draws of a stream.
struct Drawn {
  uint64_t traced = 0, byPrograms = 0, rasterised = 0;  // byPrograms: of those traced
};

/// Plays the stream to ours alone, over an OpenGL that draws nothing: nothing may break.
Drawn playAlone(const Stream& stream);

/// The calls with their arguments, one a line.
std::string describe(const Stream& stream, bool alone);

}  // namespace gluray::fuzz

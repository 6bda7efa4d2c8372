// One stream, played to a plain OpenGL and to ours: the answers must be the same, and nothing may break.
#pragma once
#include "tests/fuzz/stream.h"

#include <string>

namespace gluray::fuzz {

struct Outcome {
  std::string what;  // empty: no difference
  size_t call = 0;   // index of the call where they differ
};

/// Plays the stream to both. `state`: all queryable state is compared at the end, too. `ours` is set while
/// ours plays.
Outcome play(const Stream& stream, bool state, bool& ours);

/// The calls with their arguments, one a line.
std::string describe(const Stream& stream);

}  // namespace gluray::fuzz

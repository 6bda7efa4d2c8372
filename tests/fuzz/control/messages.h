// Random messages of the control protocol: right ones, and ones that are changed here and there.
#pragma once
#include "tests/fuzz/control/player.h"
#include "tests/fuzz/random.h"

namespace gluray::fuzz {

/// Plays a session of some hundred messages from a seed; how many there were.
uint64_t playSession(uint64_t seed);
/// Plays a session that bytes describe, as libFuzzer changes them.
void playBytes(std::string_view bytes);

}  // namespace gluray::fuzz

// Streams of calls like those of programs, made from a seed: primitives, lists, arrays, state, with misplaced
// calls now and then.
#pragma once
#include "settings/settings.h"
#include "tests/fuzz/calls.h"

#include <cstdint>
#include <vector>

namespace gluray::fuzz {

struct Call {
  const Op* op = nullptr;
  uint64_t seed = 0;  // seed of its arguments
};

struct Stream {
  std::vector<Call> calls;
  uint32_t weird = 0;         // percent of arguments that are absurd
  bool smallBuffers = false;  // see Player
  int attributeSize = 4;      // components of texture coordinates and generic attributes: avoided.md
  bool askErrors = false;     // glGetError after every call
  Engine engine = Engine::always;
  bool tame = false;  // only calls whose image can be compared
};

/// The stream of this seed, about two thousand calls. `alone`: for GLuRay over an OpenGL that draws nothing;
/// then it includes shader programs, and calls that crash real OpenGLs.
Stream makeStream(uint64_t seed, bool alone);

}  // namespace gluray::fuzz

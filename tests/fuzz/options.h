// The fuzzer's command line.
#pragma once
#include <cstdint>

namespace gluray::fuzz {

struct Options {
  uint64_t seed = 1, calls = 1000000, stream = 0;
  unsigned jobs = 1, failures = 1;
  bool differences = true;  // are failures
  bool alone = false;       // over an OpenGL that draws nothing
};

/// False where the command line is not one.
bool parse(int argc, char** argv, Options& options);

}  // namespace gluray::fuzz

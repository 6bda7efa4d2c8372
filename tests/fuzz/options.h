// The fuzzer's command line.
#pragma once
#include <cstdint>

namespace gluray::fuzz {

struct Options {
  uint64_t seed = 1, calls = 1000000, stream = 0;
  unsigned jobs = 1, failures = 1;
  bool differences = true;  // differences count as failures
  bool alone = false;       // GLuRay only, over an OpenGL that draws nothing
};

/// False if the command line is invalid.
bool parse(int argc, char** argv, Options& options);

}  // namespace gluray::fuzz

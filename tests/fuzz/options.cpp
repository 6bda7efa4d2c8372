#include "tests/fuzz/options.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace gluray::fuzz {

bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    const uint64_t value = std::strtoull(argv[i + 1], nullptr, 10);
    if (name == "--seed")
      options.seed = value;
    else if (name == "--calls")
      options.calls = value;
    else if (name == "--jobs")
      options.jobs = std::max(1u, static_cast<unsigned>(value));
    else if (name == "--failures")
      options.failures = std::max(1u, static_cast<unsigned>(value));
    else if (name == "--differences")
      options.differences = value != 0;
    else if (name == "--alone")
      options.alone = value != 0;
    else if (name == "--stream")
      options.stream = value;
    else
      return false;
  }
  return argc % 2 == 1;
}

}  // namespace gluray::fuzz

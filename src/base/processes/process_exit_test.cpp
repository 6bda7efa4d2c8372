// exit() destroys static objects after isExiting() has become true, if they were constructed before
// watchForExit().
#include "base/processes/process_exit.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

namespace gluray {
namespace {

/// A static object of a program: the process ends with code 3 if it is destroyed while isExiting().
struct Witness {
  ~Witness() { _exit(isExiting() ? 3 : 4); }
};

[[noreturn]] void exitWith(bool watch) {
  static Witness witness;
  if (watch) watchForExit();
  std::exit(isExiting() ? 5 : 6);
}

TEST(ProcessExit, IsKnownToObjectsThatWereMadeBefore) {
  EXPECT_EXIT(exitWith(true), testing::ExitedWithCode(3), "");
}

TEST(ProcessExit, IsNotKnownWithoutWatching) { EXPECT_EXIT(exitWith(false), testing::ExitedWithCode(4), ""); }

}  // namespace
}  // namespace gluray

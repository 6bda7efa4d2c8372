// The current context of a thread, as seen by destructors of static objects at exit.
#include "intercept/contexts/contexts.h"

#include "intercept/contexts/context_record.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>

namespace gluray::intercept {
namespace {

std::shared_ptr<Record>& registered() {
  static auto* record = new std::shared_ptr<Record>(std::make_shared<Record>());
  return *record;
}

/// A static window of a program, whose destructor releases its context.
struct StaticWindow {
  ~StaticWindow() {
    current() = {};
    _exit(registered().use_count() == 1 ? 3 : 4);
  }
};

[[noreturn]] void exitWithAStaticWindow() {
  registered()->group = std::make_shared<gl::ShareGroup>();
  static StaticWindow window;
  current().record = registered();
  std::exit(registered().use_count() == 2 ? 5 : 6);
}

TEST(CurrentDeathTest, MayBeUsedByDestructorsOfStaticObjects) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exitWithAStaticWindow(), testing::ExitedWithCode(3), "");
}

}  // namespace
}  // namespace gluray::intercept

#include "control/process_start.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <ctime>
#include <string>

namespace gluray::control {
namespace {

TEST(StatOf, ThisProcess) {
  const ProcessStat self = statOf(getpid());
  EXPECT_EQ(self.parent, getppid());
  EXPECT_GT(self.started, 0u);
  EXPECT_NE(self.name[0], '\0');
  const auto now = static_cast<double>(time(nullptr));
  EXPECT_LE(beginOfProcess(), now + 2);
  EXPECT_GT(beginOfProcess(), now - 24 * 3600);
}

TEST(StatOf, NamesMayHoldBracketsAndBlanks) {
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_NAME, "a) R 1 (b");
    pause();
    _exit(0);
  }
  ProcessStat seen;
  for (int i = 0; i < 1000 && std::string(seen.name) != "a) R 1 (b"; ++i) usleep(1000), seen = statOf(child);
  EXPECT_STREQ(seen.name, "a) R 1 (b");
  EXPECT_EQ(seen.parent, getpid());
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_EQ(statOf(child).parent, 0);
}

}  // namespace
}  // namespace gluray::control

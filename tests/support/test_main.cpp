// main() of the test programs. Beyond GoogleTest's own options, --cases=N requires that exactly N cases run.
// Exit code 77 (ctest: skipped) means that no case failed and that at least one was skipped.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

constexpr int kSkipped = 77;

/// The N of --cases=N, -1 without it.
int casesAskedFor(int argc, char** argv) {
  constexpr char kOption[] = "--cases=";
  for (int i = 1; i < argc; ++i)
    if (std::strncmp(argv[i], kOption, sizeof kOption - 1) == 0)
      return std::atoi(argv[i] + sizeof kOption - 1);
  return -1;
}

/// Prints the names of the skipped cases; their reasons stand in GoogleTest's output.
void printSkipped(const testing::UnitTest& tests) {
  for (int s = 0; s < tests.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *tests.GetTestSuite(s);
    for (int i = 0; i < suite.total_test_count(); ++i)
      if (const testing::TestInfo& test = *suite.GetTestInfo(i); test.result()->Skipped())
        std::printf("skipped: %s.%s\n", suite.name(), test.name());
  }
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  if (failed || GTEST_FLAG_GET(list_tests)) return failed;
  const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
  const int wanted = casesAskedFor(argc, argv), ran = tests.test_to_run_count();
  if (wanted >= 0 && ran != wanted) {
    std::printf("%d cases ran, %d are registered: build the program again\n", ran, wanted);
    return 1;
  }
  if (tests.skipped_test_count() == 0) return 0;
  printSkipped(tests);
  return kSkipped;
}

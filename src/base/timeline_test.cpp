// The file of `--timeline`. A process has one recording, so tests find their events by name.
#include "base/timeline.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace gluray::timeline {
namespace {

std::string file() {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("gluray-timeline-" + std::to_string(getpid()) + ".json"))
          .string();
  return path;
}

std::string textOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

size_t count(const std::string& text, const std::string& what) {
  size_t found = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

class Timeline : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    { const Span before("before"); }
    record(file());
  }
  static void TearDownTestSuite() {
    g_recording = false;
    std::filesystem::remove(file());
  }
};

TEST_F(Timeline, SpansMarksAndThreadsAreWritten) {
  { const Span span("work", 12345); }
  mark("moment");
  std::thread([] {
    nameThread("other");
    const Span span("elsewhere");
  }).join();
  write();
  const std::string text = textOf(file());
  EXPECT_EQ(text.substr(0, 2), "[\n");
  EXPECT_EQ(count(text, R"("ph":"X","name":"work")"), 1u);
  EXPECT_EQ(count(text, R"("args":{"n":12345})"), 1u);
  EXPECT_EQ(count(text, R"("ph":"i","s":"p","name":"moment")"), 1u);
  EXPECT_EQ(count(text, R"("args":{"name":"program"})"), 1u);
  EXPECT_EQ(count(text, R"("args":{"name":"other"})"), 1u);
  EXPECT_EQ(count(text, R"("name":"elsewhere")"), 1u);
  EXPECT_EQ(count(text, "before"), 0u);  // recording was off
}

TEST_F(Timeline, CloseSpansOfOneNameAreMerged) {
  for (int i = 0; i < 100; ++i) const Span span("tile", 2, true);
  for (int i = 0; i < 3; ++i) const Span span("single", 2);
  write();
  const std::string text = textOf(file());
  EXPECT_LT(count(text, R"("name":"tile")"), 50u);  // one, unless the machine is busy
  EXPECT_EQ(count(text, R"("name":"single")"), 3u);
}

TEST_F(Timeline, EventsAreWrittenOnce) {
  { const Span span("once"); }
  write();
  write();
  EXPECT_EQ(count(textOf(file()), R"("name":"once")"), 1u);
}

TEST_F(Timeline, ThreadsRecordWhileItIsWritten) {
  constexpr size_t kSpans = 1000, kWrites = 20;
  std::atomic<bool> done{false};
  std::thread busy([&] {
    for (size_t i = 0; i < kSpans; ++i) {
      const Span span("busy");
      std::this_thread::yield();
    }
    done = true;
  });
  for (size_t i = 0; i < kWrites || !done; ++i) write();
  busy.join();
  write();
  EXPECT_EQ(count(textOf(file()), R"("name":"busy")"), kSpans);
}

}  // namespace
}  // namespace gluray::timeline

// `gluray timeline`: reading files, the chart, the table.
#include "timeline/timeline_chart.h"
#include "timeline/timeline_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace gluray::launcher {
namespace {

class TimelineFile : public testing::Test {
 protected:
  ~TimelineFile() override { std::filesystem::remove(path_); }
  Timeline read(const std::string& text) const {
    std::ofstream(path_) << text;
    return readTimeline(path_);
  }
  std::string complaint(const std::string& text) const {
    try {
      read(text);
    } catch (const std::runtime_error& e) { return e.what(); }
    return "";
  }
  const std::string path_ =
      (std::filesystem::temp_directory_path() / ("gluray-timeline-file-" + std::to_string(getpid())))
          .string();
};

const char* const kEvents =
    R"([
{"ph":"M","name":"thread_name","pid":1,"tid":7,"args":{"name":"refining"}},
{"ph":"M","name":"thread_name","pid":1,"tid":8,"args":{"name":"refining"}},
{"ph":"M","name":"thread_name","pid":1,"tid":1,"args":{"name":"program"}},
{"ph":"X","name":"refine mesh","pid":1,"tid":7,"ts":500,"dur":1000,"args":{"n":42}},
{"ph":"X","name":"refine mesh","pid":1,"tid":8,"ts":2500,"dur":1000},
{"ph":"X","name":"trace","pid":1,"tid":1,"ts":2000,"dur":3000},
{"ph":"X","name":"batch","pid":1,"tid":1,"ts":1000,"dur":5000},
{"ph":"X","name":"batch","pid":1,"tid":1,"ts":7000,"dur":500},
{"ph":"i","s":"p","name":"frame","pid":1,"tid":1,"ts":6500},
)";

TEST_F(TimelineFile, IsReadCompleteOrTruncated) {
  const std::string whole = std::string(kEvents).substr(0, std::string(kEvents).rfind(',')) + "]";
  for (const std::string& text : {whole, std::string(kEvents), std::string(kEvents) + R"({"ph":"X","na)"}) {
    const Timeline t = read(text);
    ASSERT_EQ(t.spans.size(), 5u);
    ASSERT_EQ(t.tracks.size(), 2u);  // both jobs in one row
    EXPECT_EQ(t.tracks[0].name, "program");
    EXPECT_EQ(t.tracks[1].name, "refining");
    EXPECT_EQ(t.frames, std::vector<double>{6.5});
    EXPECT_DOUBLE_EQ(t.start, 0.5);
    EXPECT_DOUBLE_EQ(t.end, 7.5);
  }
}

TEST_F(TimelineFile, NestedSpansAreDeeper) {
  const Timeline t = read(kEvents);
  for (const Timeline::Span& span : t.spans) {
    const std::string& name = t.names[span.name];
    EXPECT_EQ(span.depth, name == "trace" ? 1 : 0) << name;
    EXPECT_EQ(span.end - span.start == 3.0, name == "trace");
    EXPECT_EQ(span.amount, span.start == 0.5 ? 42u : 0u);
  }
}

TEST_F(TimelineFile, OtherFilesAreRefusedWithOneLine) {
  EXPECT_EQ(complaint("import vtk\n"), path_ + " was not written by gluray --timeline");
  EXPECT_EQ(complaint("{\"ph\":1}"), path_ + " was not written by gluray --timeline");
  EXPECT_EQ(complaint("[{\"ph\":1}]"), path_ + " was not written by gluray --timeline");
  EXPECT_EQ(complaint("[3]"), path_ + " was not written by gluray --timeline");
  EXPECT_THROW(readTimeline("/nowhere/x.json"), std::runtime_error);
}

TEST_F(TimelineFile, BecomesAChart) {
  const Timeline t = read(kEvents);
  std::ostringstream svg;
  writeChart(t, {1, 3}, svg);
  const std::string text = svg.str();
  const auto count = [&](const std::string& what) {
    size_t found = 0;
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(text.rfind("<svg", 0), 0u);
  EXPECT_EQ(count("<title>batch: 5.000 ms</title>"), 2u);  // in both views
  EXPECT_EQ(count("<title>batch: 0.500 ms</title>"), 1u);  // not in the close-up
  EXPECT_EQ(count("<title>refine mesh: 1.000 ms, 42</title>"), 2u);
  EXPECT_EQ(count(">refining</text>"), 2u);
  EXPECT_EQ(text.substr(text.size() - 7), "</svg>\n");
}

TEST_F(TimelineFile, TimesAreAddedUp) {
  std::ostringstream out;
  printTimes(read(kEvents), out);
  EXPECT_EQ(out.str(),
            "7 ms, 1 frames\n"
            "  thread    does         times   ms  ms each\n"
            "  program   trace            1  3.0    3.000\n"
            "  program   batch            2  5.5    2.750\n"
            "  refining  refine mesh      2  2.0    1.000\n");
}

}  // namespace
}  // namespace gluray::launcher

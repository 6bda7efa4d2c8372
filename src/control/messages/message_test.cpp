// Lines and messages: complete, in pieces, and invalid.
#include "control/messages/message.h"

#include "control/messages/parsed.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::control {
namespace {

using nlohmann::json;

std::vector<std::string> linesOf(LineReader& reader) {
  std::vector<std::string> lines;
  while (auto line = reader.nextLine()) lines.push_back(*line);
  return lines;
}

TEST(LineReader, ReadsLinesHoweverTheyArrive) {
  const std::string stream = "one\n\ntwo two\nthree";
  for (size_t piece = 1; piece <= stream.size(); ++piece) {
    LineReader reader;
    std::vector<std::string> lines;
    for (size_t at = 0; at < stream.size(); at += piece) {
      ASSERT_TRUE(reader.add(stream.substr(at, piece)));
      for (std::string& line : linesOf(reader)) lines.push_back(std::move(line));
    }
    EXPECT_EQ(lines, (std::vector<std::string>{"one", "", "two two"})) << piece;
    EXPECT_EQ(reader.waiting(), 5u);
  }
}

TEST(LineReader, LinesMayBeAsLongAsTheLimit) {
  LineReader reader;
  const std::string most(kMaxBytes - 1, 'x');
  ASSERT_TRUE(reader.add(most));
  ASSERT_TRUE(reader.add("\n"));
  EXPECT_EQ(linesOf(reader), std::vector<std::string>{most});
  ASSERT_TRUE(reader.add(most + "\n" + most + "\n"));
  EXPECT_EQ(linesOf(reader).size(), 2u);
}

TEST(LineReader, LongerLinesEndIt) {
  for (const std::string& text : {std::string(kMaxBytes, 'x'), "a\n" + std::string(kMaxBytes, 'x') + "\n"}) {
    LineReader reader;
    EXPECT_FALSE(reader.add(text));
    EXPECT_FALSE(reader.add("\n"));
    EXPECT_EQ(reader.nextLine(), std::nullopt);
    EXPECT_EQ(reader.waiting(), 0u);
  }
  LineReader reader;
  bool fine = true;
  for (size_t i = 0; i < kMaxBytes / 1000 + 1; ++i) fine = fine && reader.add(std::string(1000, 'x'));
  EXPECT_FALSE(fine);
}

TEST(LineReader, DoesNotKeepWhatWasRead) {
  LineReader reader;
  for (int i = 0; i < 5000; ++i) {
    ASSERT_TRUE(reader.add(std::string(1000, 'x') + "\nrest"));
    ASSERT_TRUE(reader.nextLine());
    ASSERT_TRUE(reader.add("\n"));
    ASSERT_TRUE(reader.nextLine());
    EXPECT_EQ(reader.waiting(), 0u);
    ASSERT_LE(reader.held(), 2000u);
  }
}

TEST(LineReader, DoesNotKeepWhatWasReadOfALongStream) {
  LineReader reader;
  for (int i = 0; i < 10000; ++i) {  // its buffer is never empty
    ASSERT_TRUE(reader.add(std::string(1000, 'x') + "\nrest"));
    ASSERT_TRUE(reader.nextLine());
    ASSERT_LE(reader.held(), kMaxBytes + 4000);
  }
}

TEST(Message, IsAnObjectWithAType) {
  const Parsed parsed = parse(R"({"type": "set", "values": {"ao": true}})");
  EXPECT_EQ(parsed.why, "");
  EXPECT_EQ(parsed.message["values"]["ao"], true);
}

TEST(Message, MistakesAreOneLine) {
  for (const char* text : {"", "{", "[]", "3", "null", "{}", R"({"type": 3})", "{\"type\": \"\xff\"}",
                           "{\"type\":\"a\"} x", R"({"type": 1e999})", "{\"type\": \"a\", \"x\": \"\n\"}",
                           R"({'type': 'a'})", "\xef\xbb\xbf", R"({"type": "\ud800"})"}) {
    const Parsed parsed = parse(text);
    EXPECT_NE(parsed.why, "") << text;
    EXPECT_EQ(parsed.why.find('\n'), std::string::npos);
    EXPECT_TRUE(parsed.message.is_null()) << text;
  }
}

TEST(Message, MistakesAreShort) {
  EXPECT_LT(parse("{\"type\": \"" + std::string(kMaxBytes / 2, 'x') + "\\q\"}").why.size(), 300u);
}

TEST(Message, MayBeNestedAsDeepAsTheLimit) {
  const auto nested = [](int depth) {
    const auto more = static_cast<size_t>(depth - 1);
    return R"({"type": "a", "text": "[[[[[[[[[[[[[[[[[[[[\"[", "x": )" + std::string(more, '[') +
           std::string(more, ']') + "}";
  };
  EXPECT_EQ(parse(nested(kMaxDepth)).why, "");
  EXPECT_NE(parse(nested(kMaxDepth + 1)).why, "");
  EXPECT_NE(parse(std::string(500'000, '[')).why, "") << "no stack is used up";
}

TEST(Message, IsWrittenAsOneLine) {
  EXPECT_EQ(lineOf(json{{"type", "a"}, {"text", "two\nlines"}}),
            "{\"text\":\"two\\nlines\",\"type\":\"a\"}\n");
  EXPECT_EQ(parse(lineOf(json{{"type", "a"}, {"text", "\xff"}})).why, "");
}

}  // namespace
}  // namespace gluray::control

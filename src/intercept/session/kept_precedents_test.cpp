// The file of trials' results.
#include "intercept/session/kept_precedents.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gluray::intercept {
namespace {

constexpr int64_t kToday = 20000;

TEST(KeptPrecedents, AreReadAsWritten) {
  const std::vector<KeptPrecedents> kept{
      {{"llvmpipe (LLVM 15, 256 bits)", 2}, kToday, {{{1e6, 480000}, 0.0123, 0.4567}, {{2e6, 480000}, 1, 2}}},
      {{"a \"card\"", 16}, kToday - 3, {{{4e6, 1e6}, 0.02, 0.003}}}};
  const std::vector<KeptPrecedents> read = readPrecedents(writtenPrecedents(kept), kToday);
  ASSERT_EQ(read.size(), 2u);
  for (size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].engines, kept[i].engines);
    EXPECT_EQ(read[i].day, kept[i].day);
    EXPECT_EQ(read[i].list, kept[i].list);
  }
}

TEST(KeptPrecedents, OldOnesAndThoseOfTheFutureAreLeftOut) {
  const std::string text = writtenPrecedents({{{"old", 2}, kToday - kDaysKept - 1, {{{1, 1}, 1, 1}}},
                                              {{"valid", 2}, kToday - kDaysKept, {{{1, 1}, 1, 1}}},
                                              {{"future", 2}, kToday + 1, {{{1, 1}, 1, 1}}}});
  const std::vector<KeptPrecedents> read = readPrecedents(text, kToday);
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].engines.renderer, "valid");
}

TEST(KeptPrecedents, OnlyTheNewestEnginesAreKept) {
  std::vector<KeptPrecedents> kept;
  for (int i = 0; i < 20; ++i) kept.push_back({{"renderer", i}, kToday - 20 + i, {{{1, 1}, 1, 1}}});
  const std::vector<KeptPrecedents> read = readPrecedents(writtenPrecedents(kept), kToday);
  ASSERT_EQ(read.size(), kMostEngines);
  EXPECT_EQ(read[0].engines.threads, 19);
  EXPECT_EQ(read.back().engines.threads, 20 - static_cast<int>(kMostEngines));
}

TEST(KeptPrecedents, OtherTextIsAnError) {
  for (const char* text :
       {"", "{", "[]", "{}", R"({"format": 2, "engines": []})", R"({"format": 1})",
        R"({"format": 1, "engines": [{"renderer": 1, "threads": 2, "day": 20000, "trials": []}]})",
        R"({"format": 1, "engines": [{"renderer": "a", "threads": 2, "day": 20000, "trials": [3]}]})",
        R"({"format": 1, "engines": 7})"})
    EXPECT_THROW(readPrecedents(text, kToday), std::exception) << text;
}

}  // namespace
}  // namespace gluray::intercept

#include "settings/quirks.h"

#include <gtest/gtest.h>

#include <set>

namespace gluray {
namespace {

TEST(Quirks, AreOnUntilSwitchedOff) {
  QuirkSet quirks;
  EXPECT_TRUE(quirks.has(Quirk::materialLatch));
  EXPECT_EQ(readQuirks("material-latch=off", quirks), "");
  EXPECT_FALSE(quirks.has(Quirk::materialLatch));
  EXPECT_EQ(readQuirks("material-latch=off,material-latch=on", quirks), "");
  EXPECT_TRUE(quirks.has(Quirk::materialLatch));
}

TEST(Quirks, WrongEntriesAreReportedAndChangeNothing) {
  QuirkSet quirks;
  EXPECT_EQ(readQuirks("material-latch=no", quirks), "material-latch=no: use NAME=on or NAME=off");
  EXPECT_EQ(readQuirks("material-latch", quirks), "material-latch: use NAME=on or NAME=off");
  EXPECT_TRUE(readQuirks("latch=off", quirks).starts_with("latch: no such quirk; there is: material-latch"));
  EXPECT_EQ(quirks, QuirkSet{});
}

TEST(Quirks, RightEntriesBesideWrongOnesAreApplied) {
  QuirkSet quirks;
  EXPECT_NE(readQuirks("nothing=on,material-latch=off", quirks), "");
  EXPECT_FALSE(quirks.has(Quirk::materialLatch));
}

TEST(Quirks, EachHasANameAReasonAndATest) {
  std::set<std::string_view> names;
  for (int i = 0; i < kQuirkCount; ++i) {
    const QuirkText& text = describe(static_cast<Quirk>(i));
    EXPECT_TRUE(names.insert(text.name).second) << text.name;
    EXPECT_FALSE(text.reason.empty());
    EXPECT_TRUE(text.test.find("_test.") != text.test.npos) << text.test;
  }
}

TEST(Quirks, UsesAreCounted) {
  const uint64_t before = useCount(Quirk::materialLatch);
  noteUse(Quirk::materialLatch);
  noteUse(Quirk::materialLatch);
  EXPECT_EQ(useCount(Quirk::materialLatch), before + 2);
}

}  // namespace
}  // namespace gluray

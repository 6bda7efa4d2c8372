#include "base/printable.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

TEST(Printable, OrdinaryTextStays) {
  EXPECT_EQ(printable(""), "");
  EXPECT_EQ(printable("a file.json: \"quoted\" \\ 50 %s"), "a file.json: \"quoted\" \\ 50 %s");
  EXPECT_EQ(printable("\u00e9 \u4e2d \U0001f600"), "\u00e9 \u4e2d \U0001f600");
}

TEST(Printable, ControlsAreEscaped) {
  EXPECT_EQ(printable("a\nb\tc\rd"), "a\\nb\\tc\\x0dd");
  EXPECT_EQ(printable("\x1b[31mred\x07\x7f"), "\\x1b[31mred\\x07\\x7f");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\u009b31m"), "\\u009b31m");          // C1: CSI in one character
  EXPECT_EQ(printable("\u202egnp.exe"), "\\u202egnp.exe");  // right-to-left override
  EXPECT_EQ(printable("\u2028"), "\\u2028");
}

TEST(Printable, InvalidUtf8IsEscaped) {
  EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "\\x9b31m");
  EXPECT_EQ(printable("\xc3"), "\\xc3");                             // truncated
  EXPECT_EQ(printable("\xc0\x8a"), "\\xc0\\x8a");                    // overlong line feed
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // surrogate
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
  EXPECT_EQ(printable("\xe2\x80z"), "\\xe2\\x80z");
}

TEST(Printable, NothingIsWrittenBeyondTheEnd) {
  char out[6] = {};
  EXPECT_EQ(glurayPrintable(out, sizeof out, "abc\x1b", 4), 3u);
  EXPECT_STREQ(out, "abc");
  EXPECT_EQ(glurayPrintable(out, sizeof out, "abcdefgh", 8), 5u);
  EXPECT_STREQ(out, "abcde");
  EXPECT_EQ(glurayPrintable(out, 1, "a", 1), 0u);
  EXPECT_STREQ(out, "");
}

}  // namespace
}  // namespace gluray

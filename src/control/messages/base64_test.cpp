#include "control/messages/base64.h"

#include <gtest/gtest.h>

namespace gluray::control {
namespace {

TEST(Base64, KnownAnswers) {  // RFC 4648, section 10
  const char* const pairs[][2] = {{"", ""},
                                  {"f", "Zg=="},
                                  {"fo", "Zm8="},
                                  {"foo", "Zm9v"},
                                  {"foob", "Zm9vYg=="},
                                  {"fooba", "Zm9vYmE="},
                                  {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : pairs) {
    EXPECT_EQ(toBase64(bytes), text);
    EXPECT_EQ(fromBase64(text), bytes);
  }
}

TEST(Base64, EveryByteComesBack) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  EXPECT_EQ(fromBase64(toBase64(bytes)), bytes);
  EXPECT_EQ(toBase64("\xfb\xff\xbf"), "+/+/");
}

TEST(Base64, OtherTextsAreNone) {
  for (const char* text : {"Z", "Zg", "Zg=", "Zg =", "Z===", "====", "Zg==Zg==", "Zm9-", "Zm9v\n"})
    EXPECT_EQ(fromBase64(text), std::nullopt) << text;
}

}  // namespace
}  // namespace gluray::control

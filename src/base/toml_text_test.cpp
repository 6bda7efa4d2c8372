#include "base/toml_text.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray {
namespace {

int errorLine(const std::string& text) {
  try {
    parseToml(text);
  } catch (const toml::parse_error& e) { return static_cast<int>(e.source().begin.line); }
  return 0;
}

TEST(TomlText, MissingNamesAndValuesAreErrorsWithTheirLine) {
  EXPECT_EQ(errorLine("[=]\n"), 1);
  EXPECT_EQ(errorLine("a = 1\n\n  [[ ]]\n"), 3);
  EXPECT_EQ(errorLine("[[%a]]\n"), 1);
  EXPECT_EQ(errorLine("["), 1);
  EXPECT_EQ(errorLine(std::string("[[\0]]", 5)), 1);
  EXPECT_EQ(errorLine("\na = {b = }\n"), 2);
  EXPECT_EQ(errorLine("a =\n"), 1);
  EXPECT_EQ(errorLine("a = [}\n"), 1);
  EXPECT_GT(errorLine("a = [1,\n"), 0);
}

TEST(TomlText, BracketsInValuesStringsAndCommentsAreNone) {
  EXPECT_EQ(errorLine("[a]\n[[ b ]]\n['c']\n[\"d\"]\n[-]\n"), 0);
  EXPECT_EQ(errorLine("a = [\n[{b = 1}],\n[ ],\n]\n[c]\n"), 0);
  EXPECT_EQ(errorLine("a = \"\"\"\n[%]\n\\\"\"\"\"\nb = '''\n[=]\n'''\n# it's\n[c]\n"), 0);
  EXPECT_EQ(errorLine("a = 'it\\'\nb = \"\\\"\"\n[c]\n"), 0);
}

TEST(TomlText, AnyTextParsesOrFails) {
  const std::string good =
      "[[light]]\nkind = 'spot'\np = [0, 4, 0]\ns = \"\"\"\n[x]\"\"\"\n[a.b]\nc = {d = 1}\n";
  for (size_t i = 0; i < good.size(); ++i)
    for (const char c : {'\0', '[', ']', '\'', '"', '9', 'e', '\n', '=', '{', '#', '.'}) {
      std::string broken = good;
      broken[i] = c;
      errorLine(broken);
      errorLine(broken.substr(0, i + 1));
    }
}

}  // namespace
}  // namespace gluray

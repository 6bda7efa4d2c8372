// [[code]] sections of family files, and families that name them.
#include "gl/families/family.h"
#include "gl/testing/test_family_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

TEST(CodeSections, ReadsNamedSectionsOfStatements) {
  const FamilyList list = parseFamilies(kMin +
                                            "match.code = [\"one\", \"two\"]\n"
                                            "[[code]]\nname = \"one\"\nstatements = \"a = 1.0; b = 2.0;\"\n"
                                            "[[code]]\nname = \"one\"\nstatements = \"b = 2.; c;\"\n",
                                        "x.toml");
  EXPECT_EQ(list.at(0)->code, (std::vector<std::string>{"one", "two"}));
  ASSERT_EQ(list.code.size(), 1u);
  EXPECT_EQ(list.code.at("one").size(), 3u);
  EXPECT_TRUE(list.code.at("one").has(hashOf("a=1.;")));
  EXPECT_FALSE(list.code.at("one").has(hashOf("a=2.;")));
  EXPECT_TRUE(parseFamilies(kMin, "x.toml").at(0)->code.empty());
  EXPECT_TRUE(parseFamilies(kMin + "match.code = \"any\"\n", "x.toml").at(0)->code.empty());

  EXPECT_EQ(mistake("[[code]]\nstatements = \"a;\"\n"), "x.toml:1: code needs a name");
  EXPECT_EQ(mistake("[[code]]\nname = \"a\"\n"),
            "x.toml:1: code \"a\" needs statements, blocks, fragments or shaders");
  EXPECT_EQ(mistake("[[code]]\nname = \"any\"\nstatements = \"a;\"\n"),
            "x.toml:2: code cannot be named \"any\"");
  EXPECT_EQ(mistake("[[code]]\nname = \"a\"\nstatements = \"a;\"\nfor = 1\n"),
            "x.toml:4: unknown key \"for\"");
  EXPECT_EQ(mistake("code = 3\n"), "x.toml:1: only [[family]] and [[code]] sections are expected here");
}

TEST(CodeSections, ReadsBlocksAndWrittenNames) {
  FamilyList list = parseFamilies(
      kMin + "[[code]]\nname = \"one\"\nblocks = \"a; b;\\n\\n\\nb; c;\"\nwritten = [\"v\", \"w\"]\n",
      "x.toml");
  EXPECT_EQ(list.code.at("one").size(), 3u);
  EXPECT_EQ(list.code.at("one").blocks().size(), 2u);
  list.append(parseFamilies("[[code]]\nname = \"one\"\nblocks = \"d;\"\nwritten = \"x\"\n", "y.toml"));
  EXPECT_EQ(list.code.at("one").size(), 4u);
  EXPECT_EQ(list.code.at("one").blocks().size(), 3u);
  EXPECT_EQ(list.code.at("one").written(), (std::set<std::string>{"v", "w", "x"}));
}

TEST(CodeSections, ReadsDigestsOfShaders) {
  const std::string one(32, '1'), two(32, 'f');
  FamilyList list = parseFamilies("[[code]]\nname = \"a\"\nshaders = \"" + one + "\"\n", "x.toml");
  list.append(parseFamilies("[[code]]\nname = \"a\"\nshaders = [\"" + two + "\"]\n", "y.toml"));
  EXPECT_EQ(knownShaders(list.code, {"a"}).size(), 2u);
  EXPECT_EQ(knownShaders(list.code, {"b"}).size(), 0u);
  EXPECT_EQ(mistake("[[code]]\nname = \"a\"\nshaders = \"12x\"\n"),
            "x.toml:3: \"12x\" is not a digest of 32 hexadecimal digits");
}

TEST(CodeSections, AppendMergesSectionsOfOneName) {
  FamilyList list = parseFamilies(kMin + "[[code]]\nname = \"one\"\nstatements = \"a;\"\n", "x.toml");
  list.append(parseFamilies("[[code]]\nname = \"one\"\nstatements = \"b;\"\n", "y.toml"));
  list.append(parseFamilies(kMin, "z.toml"));
  EXPECT_EQ(list.size(), 2u);
  EXPECT_EQ(list.code.at("one").size(), 2u);
}

TEST(CodeSections, FamiliesMustNameExistingSections) {
  const std::string code = "match.code = [\"one\", \"tow\"]\n[[code]]\nname = \"one\"\nstatements = \"a;\"\n";
  FamilyList list = parseFamilies(kMin + code, "x.toml");
  const auto wrong = [&](const CodeSections& known) -> std::string {
    try {
      needSections(list, known);
    } catch (const FamilyError& e) { return e.what(); }
    return "none";
  };
  EXPECT_EQ(wrong(list.code), "x.toml:6: there is no [[code]] section \"tow\"; there are \"one\"");
  EXPECT_EQ(wrong({}), "x.toml:6: there is no [[code]] section \"one\"");
  CodeSections more = list.code;
  more["tow"].add("b;");
  EXPECT_EQ(wrong(more), "none") << "other files may have it";
}

TEST(CodeSections, NotesApplyToProgramsWithTheStatements) {
  const FamilyList list = parseFamilies(
      "[[code]]\nname = \"one\"\nnote = \"n1\"\nstatements = \"a = 1.0;\"\n"
      "[[code]]\nname = \"two\"\nnote = \"n2\"\nstatements = \"b = 1.0;\"\n",
      "x.toml");
  const auto notes = [&](const char* text, const std::vector<std::string>& names) {
    GlslStatements statements;
    statements.cut(text);
    return notesOn(statements, list.code, names);
  };
  EXPECT_EQ(notes("a = 1.;", {"one", "two"}), "n1");
  EXPECT_EQ(notes("a = 1.; b = 1.;", {"one", "two"}), "n1; n2");
  EXPECT_EQ(notes("a = 1.;", {"two"}), "");
}

/// Built-in families that are traced, or whose passes we make, name existing sections for their statements.
TEST(CodeSections, BuiltInFamiliesNameTheirCode) {
  const FamilyList& all = builtInFamilies();
  for (const auto& family : all) {
    const bool ours = family->pass == Family::Pass::fxaa || family->pass == Family::Pass::resolve;
    if (!family->rasteriseBecause.empty() && !ours) continue;
    EXPECT_FALSE(family->code.empty()) << family->name;
    for (const std::string& name : family->code)
      EXPECT_TRUE(all.code.contains(name)) << family->name << ": " << name;
  }
}

}  // namespace
}  // namespace gluray::gl

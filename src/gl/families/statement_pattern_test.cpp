// Slots in known statements: how statements are compared with them, and which word each group has.
#include "gl/families/statement_pattern.h"

#include "gl/families/known_code.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

using Texts = std::vector<std::string>;

GlslStatements statementsOf(const std::string& text) {
  GlslStatements statements;
  statements.cut(text);
  return statements;
}

/// A section with the statements of a ray caster, whose fragments stand in another one.
class SlotsTest : public testing::Test {
 protected:
  SlotsTest() {
    KnownCode& code = sections_["code"];
    code.add(
        "vec4 cast() { @blend.start while (true) { @crop take(); @blend.sample } @blend.end return c; }");
    code.add("@blend.global; float q = @blend.factor x;");
    KnownCode& fragments = sections_["fragments"];
    fragments.addFragment("blend", "maximum", "start", "m = vec4(0.0);");
    fragments.addFragment("blend", "maximum", "sample", "if (m < s) { m = s; }");
    fragments.addFragment("blend", "maximum", "sample", "m = max(m, s);");
    fragments.addFragment("blend", "maximum", "end", "c = m;");
    fragments.addFragment("blend", "maximum", "global", "vec4 m");
    fragments.addFragment("blend", "sum", "sample", "c += $weight * s;");
    fragments.addFragment("blend", "sum", "factor", "2.0 *");
    fragments.addFragment("crop", "box", "", "if (@side < low) skip();");
    fragments.addFragment("crop", "box", "", "int n = $n; if (outside(n)) skip();");
    fragments.addFragment("side", "left", "", "p.x");
    fragments.addFragment("side", "top", "", "p.y");
  }
  Texts unknown(const std::string& text) const {
    const GlslStatements statements = statementsOf(text);
    const auto found = unknownStatements(statements, sections_, both_);
    return Texts(found.begin(), found.end());
  }
  bool known(const std::string& text) const { return unknown(text).empty(); }
  /// The name of a group without a word; empty: they are in words_.
  std::string wordless(const std::string& text) {
    words_.clear();
    return readWords(statementsOf(text), sections_, both_, words_);
  }
  CodeSections sections_;
  SlotWords words_;
  const Texts both_{"code", "fragments"};
};

/// cast() with these fragments.
std::string castWith(const std::string& start, const std::string& crop, const std::string& sample,
                     const std::string& end) {
  return "vec4 cast() { " + start + " while (true) { " + crop + " take(); " + sample + " } " + end +
         " return c; }";
}

TEST_F(SlotsTest, StandForFragmentsOrNothing) {
  EXPECT_TRUE(known(castWith("m = vec4(0.);", "", "if (m < s) { m = s; }", "c = m;")));
  EXPECT_TRUE(known(castWith("m = vec4(0.);", "", "m = max(m, s);", "c = m;"))) << "the other text";
  EXPECT_TRUE(known(castWith("", "", "c += .5 * s;", "")));
  EXPECT_TRUE(known(castWith("", "", "", "")));
  EXPECT_FALSE(known(castWith("", "", "c += s;", "")));
  EXPECT_FALSE(known(castWith("c = m;", "", "", ""))) << "of another part";
  EXPECT_FALSE(known(castWith("m = vec4(0.); m = vec4(0.);", "", "", "")));
  EXPECT_FALSE(known(castWith("m = vec4(0.)", "", "", ""))) << "a part of a fragment";
  EXPECT_FALSE(known("vec4 cast() { m = vec4(0.0); }"));
  EXPECT_FALSE(known("vec4 cast() { while (true) { take(); } return c; } float more;"));
}

TEST_F(SlotsTest, FragmentsHaveNumbersAndSlots) {
  EXPECT_TRUE(known(castWith("", "if (p.x < low) skip();", "", "")));
  EXPECT_TRUE(known(castWith("", "if (p.y < low) skip();", "", "")));
  EXPECT_TRUE(known(castWith("", "int n = 3; if (outside(n)) skip();", "", "")));
  EXPECT_FALSE(known(castWith("", "if (p.z < low) skip();", "", "")));
  EXPECT_FALSE(known(castWith("", "int n = k; if (outside(n)) skip();", "", "")));
  PlaceholderValues values;
  const GlslStatements both =
      statementsOf(castWith("", "int n = 3; if (outside(n)) skip();", "c += 0.5 * s;", ""));
  EXPECT_EQ(readPlaceholders(both, sections_, both_, values), "");
  EXPECT_EQ(values, (PlaceholderValues{{"$n", 3}, {"$weight", 0.5f}}));
}

TEST_F(SlotsTest, TokensStayWhole) {
  EXPECT_TRUE(known("float q = 2.0 * x;"));
  EXPECT_TRUE(known("float q = x;"));
  EXPECT_FALSE(known("float q = 12.0 * x;"));
  EXPECT_FALSE(known("float q = 2.0 * xx;"));
  sections_["code"].add("int f() { return @kind.name + a; }");
  sections_["code"].addFragment("kind", "a", "name", "depth");
  sections_["code"].addFragment("kind", "a", "name", "5");
  sections_["code"].addFragment("kind", "a", "name", ".5");
  for (const char* const name : {"depth", "5", ".5", "0.5", ""})
    EXPECT_TRUE(known("int f() { return " + std::string(name) + " + a; }")) << name;
  for (const char* const name : {"depths", "dept", "55", ".55", "1.5", "returndepth"})
    EXPECT_FALSE(known("int f() { return " + std::string(name) + " + a; }")) << name;
  EXPECT_FALSE(known("int f() { returndepth + a; }"));
}

TEST_F(SlotsTest, DirectivesKeepTheirLines) {
  sections_["code"].add("void g() { a();\n@when\nb(); }");
  sections_["fragments"].addFragment("when", "es", "", "#ifdef GL_ES // or not\n  c();\n#endif\n");
  EXPECT_TRUE(known("void g() { a();\n#ifdef GL_ES\nc();\n#endif\nb(); }"));
  EXPECT_TRUE(known("void g() { a(); b(); }"));
  EXPECT_FALSE(known("void g() { a();\n#ifdef GL_ES\nc();\nb();\n#endif\n }"));
}

TEST_F(SlotsTest, WhatFitsInOneWayIsFound) {
  sections_["code"].add("int h() { @a @b c(); }");
  for (const char* const text : {"x();", "x(); y();", "y();"})
    sections_["code"].addFragment("a", "one", "", text), sections_["code"].addFragment("b", "one", "", text);
  for (const char* const text :
       {"", "x();", "x(); y();", "y(); x();", "x(); y(); y();", "x(); y(); x(); y();"})
    EXPECT_TRUE(known("int h() { " + std::string(text) + " c(); }")) << text;
  for (const char* const text : {"x(); y(); x(); y(); x();", "z();", "x(); x(); x();"})
    EXPECT_FALSE(known("int h() { " + std::string(text) + " c(); }")) << text;
}

/// There are more than 10^30 ways to divide 100 statements among 24 slots with fragments that have slots.
TEST_F(SlotsTest, ManyWaysTakeNoLongerThanOne) {
  std::string text = "int h() {", repeated, pattern = "int h() {", fragment;
  for (int i = 0; i < 8; ++i) sections_["code"].addFragment("a", "w", "", repeated += "@b x();");
  for (const char* const name : {"b", "c", "d"}) {
    const std::string inner = name[0] == 'd' ? "x();" : std::string("@") + static_cast<char>(name[0] + 1);
    sections_["code"].addFragment(name, "w", "", inner + (name[0] == 'd' ? "" : " " + inner));
  }
  for (int i = 0; i < 24; ++i) pattern += " @a";
  sections_["code"].add(pattern + " end(); }");
  for (int i = 0; i < 100; ++i) text += " x();";
  EXPECT_FALSE(known(text + " other(); }"));
  EXPECT_FALSE(known(text + " y(); end(); }"));
  EXPECT_TRUE(known(text + " end(); }"));
}

TEST_F(SlotsTest, AllSlotsOfAGroupHaveOneWord) {
  EXPECT_EQ(wordless(castWith("m = vec4(0.);", "", "m = max(m, s);", "c = m;") + " vec4 m;"), "");
  EXPECT_EQ(words_, (SlotWords{{"@blend", "maximum"}, {"@crop", ""}}));
  EXPECT_EQ(wordless(castWith("", "if (p.y < low) skip();", "c += .5 * s;", "") + "float q = 2. * x;"), "");
  EXPECT_EQ(words_, (SlotWords{{"@blend", "sum"}, {"@crop", "box"}, {"@side", "top"}}));
  EXPECT_EQ(wordless(castWith("m = vec4(0.);", "", "c += .5 * s;", "c = m;")), "@blend");
  EXPECT_EQ(wordless(castWith("m = vec4(0.);", "", "m = max(m, s);", "")), "@blend") << "one is missing";
  EXPECT_EQ(wordless(castWith("", "", "c += .5 * s;", "") + "float q = x;"), "@blend")
      << "in another statement";
  EXPECT_EQ(wordless(castWith("", "", "c += .5 * s;", "") + "vec4 m;"), "@blend");
  EXPECT_EQ(wordless(castWith("", "", "", "")), "");
  EXPECT_EQ(words_, (SlotWords{{"@blend", ""}, {"@crop", ""}}));
  EXPECT_EQ(wordless("float z;"), "");
  EXPECT_EQ(words_, SlotWords{}) << "no slot";
}

TEST_F(SlotsTest, TheFirstOfSeveralWordsCounts) {
  KnownCode& code = sections_["fragments"];
  code.addFragment("blend", "last", "start", "m = vec4(0.);");
  code.addFragment("blend", "last", "start", "");
  code.addFragment("blend", "last", "end", "d = m;");
  EXPECT_EQ(wordless(castWith("m = vec4(0.);", "", "", "d = m;")), "");
  EXPECT_EQ(words_.at("@blend"), "last");
  EXPECT_EQ(wordless(castWith("", "", "", "d = m;")), "") << "an empty alternative";
  EXPECT_EQ(words_.at("@blend"), "last");
  code.addFragment("blend", "least", "end", "d = m;");
  EXPECT_EQ(wordless(castWith("", "", "", "d = m;")), "");
  EXPECT_EQ(words_.at("@blend"), "last");
  code.addWord("blend", "nothing");
  EXPECT_EQ(wordless(castWith("", "", "", "")), "");
  EXPECT_EQ(words_.at("@blend"), "nothing") << "a word without fragments";
}

TEST_F(SlotsTest, ARequiredGroupHasAWord) {
  const std::string empty = castWith("", "", "", "");
  EXPECT_EQ(wordless(empty), "");
  sections_["fragments"].requireWord("blend");
  EXPECT_EQ(wordless(empty), "@blend");
  EXPECT_EQ(wordless(castWith("", "", "c += .5 * s;", "")), "");
  EXPECT_EQ(words_, (SlotWords{{"@blend", "sum"}, {"@crop", ""}}));
  sections_["fragments"].addWord("blend", "nothing");
  EXPECT_EQ(wordless(empty), "");
  EXPECT_EQ(words_.at("@blend"), "nothing");
  KnownCode merged;
  merged.add(sections_["fragments"]);
  EXPECT_TRUE(merged.fragments().isRequired("blend"));
  EXPECT_FALSE(merged.fragments().isRequired("crop"));
}

TEST_F(SlotsTest, DirectivesHaveNumbers) {
  sections_["code"].add("#define LIGHTS $lights\n");
  PlaceholderValues values;
  const GlslStatements statements = statementsOf("#define LIGHTS 3\n");
  EXPECT_TRUE(unknownStatements(statements, sections_, both_).empty());
  EXPECT_EQ(readPlaceholders(statements, sections_, both_, values), "");
  EXPECT_EQ(values, (PlaceholderValues{{"$lights", 3}}));
  EXPECT_FALSE(known("#define LIGHTS x\n"));
}

TEST_F(SlotsTest, ConditionsOfDirectivesHaveNumbers) {
  sections_["code"].add(
      "#if $count\nint steps[$count + 2];\n#endif\nint g() {\n#if $count\nreturn $count;\n#endif\n}");
  for (const std::string count : {"1", "3", "12"}) {
    const std::string text = "#if " + count + "\nint steps[" + count + " + 2];\n#endif\nint g() {\n#if " +
                             count + "\nreturn " + count + ";\n#endif\n}";
    EXPECT_EQ(unknown(text), Texts{}) << text;
    PlaceholderValues values;
    EXPECT_EQ(readPlaceholders(statementsOf(text), sections_, both_, values), "");
    EXPECT_EQ(values, (PlaceholderValues{{"$count", std::stof(count)}}));
  }
  EXPECT_EQ(unknown("#if X\n"), Texts{"#if X"});
}

TEST_F(SlotsTest, WordsOfSeveralSectionsAreOne) {
  sections_["more"].addFragment("blend", "sum", "end", "c = c / n;");
  const Texts all{"code", "fragments", "more"};
  EXPECT_EQ(readWords(statementsOf(castWith("", "", "c += 2. * s;", "c = c / n;")), sections_, all, words_),
            "");
  EXPECT_EQ(words_.at("@blend"), "sum");
  EXPECT_EQ(readWords(statementsOf(castWith("", "", "c += 2. * s;", "")), sections_, all, words_), "@blend")
      << "the word has a text there";
  sections_["fragments"].add(sections_["more"]);
  EXPECT_TRUE(known(castWith("", "", "c += 2. * s;", "c = c / n;"))) << "merged";
}

TEST_F(SlotsTest, RulesOfKnownStatementsHold) {
  sections_["code"].addBlocks("d = @color;\nf = d;\n");
  sections_["code"].complete = true, sections_["fragments"].note = "n1", sections_["code"].note = "n2";
  sections_["fragments"].addFragment("color", "red", "", "vec3(1., 0., 0.)");
  const auto stray = [&](const std::string& main) {
    const GlslStatements statements = statementsOf("void main() {" + main + "}");
    const auto found = strayStatements(statements, sections_, both_);
    return Texts(found.begin(), found.end());
  };
  const GlslStatements whole = statementsOf("void main() { d = vec3(1., 0., 0.); f = d; }"),
                       half = statementsOf("void main() { d = vec3(1., 0., 0.); }");
  EXPECT_EQ(stray("d = vec3(1., 0., 0.); f = d;"), Texts{});
  EXPECT_EQ(stray("d = vec3(1., 0., 0.);"), Texts{"d=vec3(1.,0.,0.);"});
  EXPECT_EQ(incompleteSections(whole, sections_, both_), Texts{});
  EXPECT_EQ(incompleteSections(half, sections_, both_), Texts{"code"});
  EXPECT_EQ(notesOn(half, sections_, both_), "n2");
  EXPECT_EQ(stray("float q = 2. * x; float q = 2. * x;"), Texts{"float q=2.*x;"}) << "repeated";
}

TEST_F(SlotsTest, UnknownSlotsAreEmpty) {
  const GlslStatements statements =
      statementsOf(castWith("", "", "", "") + castWith("", "", "m = max(m, s);", ""));
  EXPECT_EQ(unknownStatements(statements, sections_, {"code"}).size(), 1u);
}

TEST(PatternText, IsCutAtNames) {
  const PatternText call("a=$b(c)+$d;");
  ASSERT_EQ(call.pieces().size(), 5u);
  EXPECT_EQ(call.pieces()[1].kind, PatternText::Piece::Kind::function);
  EXPECT_EQ(call.pieces()[1].text, "$b");
  EXPECT_EQ(call.pieces()[3].kind, PatternText::Piece::Kind::number);
  const PatternText text("a @b.c d$e f@g.h.i@j.");
  Texts all;
  for (const PatternText::Piece& piece : text.pieces()) all.push_back(piece.text + "|" + piece.part);
  EXPECT_EQ(all, (Texts{"a |", "b|c", "d|", "$e|", "f|", "g|h", ".i|", "j|", ".|"}));
  EXPECT_FALSE(text.isPlain());
  EXPECT_TRUE(PatternText("a.b").isPlain());
}

}  // namespace
}  // namespace gluray::gl

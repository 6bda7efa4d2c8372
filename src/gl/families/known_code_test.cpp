// Further conditions on known statements: blocks are whole, no statement is repeated, and names that are read
// are also written.
#include "gl/families/known_code.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

using Texts = std::vector<std::string>;

class KnownCodeTest : public testing::Test {
 protected:
  KnownCodeTest() {
    sections_["one"].add("float a; d = a; d = light0; f(); for (i = 0; i < 3; ++i) { }");
    sections_["one"].addBlocks(
        "a = 1.0;\nb = a;\nc = light0;\n\na = 1.0;\nb = a;\n\nfloat q = b;\nq *= 2.0;\n");
    sections_["one"].addWritten("vOut");
  }
  Texts stray(const std::string& main) {
    GlslStatements statements;
    statements.cut("void main() {" + main + "}");
    const auto found = strayStatements(statements, sections_, {"one", "none"});
    return Texts(found.begin(), found.end());
  }
  Texts unwritten(const std::string& first, const std::string& second) {
    GlslStatements statements;
    statements.cut("void main() {" + first + "}"), statements.cut("void main() {" + second + "}");
    return unwrittenNames(statements, sections_, {"one"});
  }
  CodeSections sections_;
};

TEST_F(KnownCodeTest, StatementsOfBlocksAreKnown) {
  GlslStatements statements;
  statements.cut("void main() { a = 1.; b = a; c = light3; }");
  EXPECT_TRUE(unknownStatements(statements, sections_, {"one"}).empty());
}

TEST_F(KnownCodeTest, WholeBlocksAreNotStray) {
  EXPECT_EQ(stray("a = 1.; b = a; c = light3; d = a;"), Texts{});
  EXPECT_EQ(stray("a = 1.; b = a; c = light3; a = 1.; b = a; c = light4;"), Texts{}) << "one block per light";
  EXPECT_EQ(stray("a = 1.; b = a;"), Texts{}) << "a shorter one";
  EXPECT_EQ(stray("float q = b; q *= 2.;"), Texts{});
}

TEST_F(KnownCodeTest, PartsOfBlocksAreStray) {
  EXPECT_EQ(stray("a = 1.; c = light3;"), (Texts{"a=1.;", "c=light#;"}));
  EXPECT_EQ(stray("float q = b;"), Texts{"float q=b;"});
  EXPECT_EQ(stray("float q = b; q *= 2.; q *= 2.;"), Texts{"q*=2.;"});
  EXPECT_EQ(stray("b = a; a = 1.;"), (Texts{"b=a;", "a=1.;"})) << "in another order";
  EXPECT_EQ(stray("a = 1.; d = a; b = a;"), (Texts{"a=1.;", "b=a;"})) << "with something between";
}

TEST_F(KnownCodeTest, RepeatedComputationsAreStray) {
  EXPECT_EQ(stray("d = a; float a; d = a;"), Texts{"d=a;"});
  EXPECT_EQ(stray("d = light1; d = light2;"), Texts{}) << "two lights";
  EXPECT_EQ(stray("f(); f(); for (i = 0; i < 3; ++i) { } for (i = 0; i < 3; ++i) { }"), Texts{});
}

TEST_F(KnownCodeTest, UnknownStatementsAreNotStrayAsWell) { EXPECT_EQ(stray("z = 1.; z = 1.;"), Texts{}); }

class PlaceholdersTest : public testing::Test {
 protected:
  PlaceholdersTest() {
    sections_["one"].add("float f(float x) { return max(x, $floor); } y = $a * x + $b;");
    sections_["one"].addBlocks("p = pow(p, vec3(1.0 / $e));\nq = pow(q, vec3(1.0 / $e));\n");
  }
  static GlslStatements cut(const std::string& text) {
    GlslStatements statements;
    statements.cut(text);
    return statements;
  }
  Texts unknown(const std::string& text) {
    const GlslStatements statements = cut(text);
    const auto found = unknownStatements(statements, sections_, {"one"});
    return Texts(found.begin(), found.end());
  }
  CodeSections sections_;
};

TEST_F(PlaceholdersTest, StandForAnyNumber) {
  for (const char* number : {"1e-8", "0.25f", ".5", "3.", "7", "2.5E+3", "0.0"})
    EXPECT_EQ(unknown(std::string("float f(float x) { return max(x, ") + number + "); }"), Texts{}) << number;
  for (const char* other : {"-1.0", "y", "1.0 + 2.0", "0x10", "1u", "vec3(1.0)", "", "1.0.0"})
    EXPECT_EQ(unknown(std::string("float f(float x) { return max(x, ") + other + "); }").size(), 1u) << other;
  EXPECT_EQ(unknown("void main() { y = 2.0 * x + 1.0; }"), Texts{});
  EXPECT_EQ(unknown("void main() { y = 2.0 * x - 1.0; }"), Texts{"y=2.*x-1.;"});
}

TEST_F(PlaceholdersTest, AreReadFromStatements) {
  PlaceholderValues values;
  const GlslStatements both =
      cut("float f(float x) { return max(x, 1e-8); } void main() { y = 2.0 * x + 1.0; }");
  EXPECT_EQ(readPlaceholders(both, sections_, {"one"}, values), "");
  EXPECT_EQ(values, (PlaceholderValues{{"$floor", 1e-8f}, {"$a", 2.0f}, {"$b", 1.0f}}));
  PlaceholderValues none;
  EXPECT_EQ(readPlaceholders(cut("void main() { z = 1.0; }"), sections_, {"one"}, none), "");
  EXPECT_TRUE(none.empty());
}

TEST_F(PlaceholdersTest, OfOneNameHaveOneNumber) {
  const auto blocks = [&](const char* a, const char* b) {
    return cut(std::string("void main() { p = pow(p, vec3(1.0/") + a + ")); q = pow(q, vec3(1.0/" + b +
               ")); }");
  };
  PlaceholderValues values;
  EXPECT_EQ(readPlaceholders(blocks("2.2", "2.2"), sections_, {"one"}, values), "");
  EXPECT_EQ(strayStatements(blocks("2.2", "2.2"), sections_, {"one"}).size(), 0u);
  EXPECT_EQ(values, (PlaceholderValues{{"$e", 2.2f}}));
  PlaceholderValues different;
  EXPECT_EQ(readPlaceholders(blocks("2.2", "1.8"), sections_, {"one"}, different), "$e");
  const GlslStatements half = cut("void main() { p = pow(p, vec3(1.0/2.2)); }");
  EXPECT_EQ(strayStatements(half, sections_, {"one"}).size(), 1u) << "a part of a block";
}

TEST_F(KnownCodeTest, NamesThatAreReadMustBeWritten) {
  EXPECT_EQ(unwritten("vOut = x;", "vec3 n = vOut;"), Texts{});
  EXPECT_EQ(unwritten("vOut[i].xy = x;", "vec3 n = vOut;"), Texts{});
  EXPECT_EQ(unwritten("if (c) { vOut = x; } else { vOut = y; }", "vec3 n = vOut;"), Texts{});
  EXPECT_EQ(unwritten("x = y;", "vec3 vOut = cross(x, y); if (c) { vOut = -vOut; }"), Texts{})
      << "another one";
  EXPECT_EQ(unwritten("x = y;", "vec3 n = vOut;"), Texts{"vOut"});
  EXPECT_EQ(unwritten("vOut2 = x; xvOut = y;", "vec3 n = vOut;"), Texts{"vOut"});
  EXPECT_EQ(unwritten("x = y;", "vec3 vOut = normalize(vOut); if (c) { vOut = -vOut; }"), Texts{"vOut"});
  EXPECT_EQ(unwritten("if (vOut == x) y = 1.;", "z = 1.;"), Texts{"vOut"});
  EXPECT_EQ(unwritten("x = y;", "y = x;"), Texts{});
}

}  // namespace
}  // namespace gluray::gl

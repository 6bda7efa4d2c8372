#include "gl/glsl/glsl_branches.h"

#include "gl/glsl/glsl_statements.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

/// The statements of main() with these branches decided, one a line.
std::string decided(const std::string& body, const DecidedValues& values) {
  GlslStatements statements;
  statements.cut(decideBranches("void main() {" + body + "}", values));
  std::string all;
  for (size_t i = 0; i < statements.size(); ++i) all.append(statements[i]).push_back('\n');
  return all;
}

TEST(GlslBranches, AreReplacedByTheBranchThatIsTaken) {
  const std::string chain = "if (k == 1) { a(); } else if (k == 3) { b(); c(); } else { d(); }";
  EXPECT_EQ(decided(chain, {{"k", 1}}), "a();\n");
  EXPECT_EQ(decided(chain, {{"k", 3}}), "b();\nc();\n");
  EXPECT_EQ(decided(chain, {{"k", 5}}), "d();\n");
  EXPECT_EQ(decided(chain, {}), "if(k==1){a();}else if(k==3){b();c();}else{d();}\n");
}

TEST(GlslBranches, FollowFromPartsOfConditions) {
  const DecidedValues values{{"k", 5}, {"w", 0}};
  EXPECT_EQ(decided("if (((e == 1) || (w == 1)) && (k == 3)) { a(); } b();", values), "b();\n");
  EXPECT_EQ(decided("if ((u.x > 1 || k == 5) && w <= 0 && !(k < 2)) a();", values), "a();\n");
  EXPECT_EQ(decided("if (f(k, 1) && w != 0) a(); else b();", values), "b();\n");
  EXPECT_EQ(decided("if (k >= 5.0 && k > 4 && 3 < k && true) a();", values), "a();\n");
  EXPECT_EQ(decided("if (w) a(); if (!w) b(); if (k) c();", values), "b();\nc();\n");
}

TEST(GlslBranches, StayWhereTheirConditionsAreNotKnown) {
  const DecidedValues values{{"k", 5}};
  for (const std::string condition : {"k%3==2", "k+1==6", "v.k==5", "k==n", "f(k)==5", "n==5&&k==5",
                                      "a[k]==5", "-k==5", "n==5||k==1", "k==5.e"})
    EXPECT_EQ(decided("if(" + condition + "){a();}", values), "if(" + condition + "){a();}\n") << condition;
}

TEST(GlslBranches, AreDecidedWithinOthers) {
  const DecidedValues values{{"k", 5}};
  EXPECT_EQ(
      decided("if (n == 1) { if (k == 5) { a(); } else { b(); } } else if (k == 1) c(); else { d(); e(); }",
              values),
      "if(n==1){a();}else{d();e();}\n");
  EXPECT_EQ(decided("if (k == 5) if (n == 1) a(); else b();", values), "if(n==1)a();else b();\n");
  EXPECT_EQ(decided("if (n == 1) if (k == 1) a(); b();", values), "if(n==1){}\nb();\n");
  EXPECT_EQ(decided("for (int i = 0; i < 3; ++i) { if (k == 5) { a(); } }", values),
            "for(int i=0;i<3;++i){\na();\n");
  EXPECT_EQ(decided("if (k == 1) for (int i = 0; i < 3; ++i) { a(); } b();", values), "b();\n");
  EXPECT_EQ(decided("if (k == 1) do { a(); } while (n > 0); else while (n > 0) { b(); } c();", values),
            "while(n>0){b();}\nc();\n");
}

TEST(GlslBranches, LeaveDirectivesAndFunctionsAlone) {
  GlslStatements statements;
  statements.cut(
      decideBranches("#version 150\n#define A(x) x + 1\n#if k == 1\nfloat f(int k) { if (k == 5) { "
                     "return 1.0; } return 0.50; }\n#endif\nvoid main() { /* if (k) */ a(); }",
                     {{"k", 5}}));
  std::string all;
  for (size_t i = 0; i < statements.size(); ++i) all.append(statements[i]).push_back('\n');
  EXPECT_EQ(all, "#define A(x)x+1\n#if k ==1\nfloat f(int k){if(k==5){return 1.;}return.5;}\n#endif\na();\n");
}

TEST(GlslBranches, SurviveTextsThatEndEarly) {
  for (const std::string text :
       {"if", "if (", "if (k == 5", "if (k == 5)", "if (k == 5) {", "if (k == 1) a(); else",
        "void main() { if (k == 5) { a(); ", "do", "for (", ") } ]", "#", "if ((k"})
    EXPECT_LE(decideBranches(text, {{"k", 5}}).size(), text.size() * 2 + 8) << text;
}

}  // namespace
}  // namespace gluray::gl

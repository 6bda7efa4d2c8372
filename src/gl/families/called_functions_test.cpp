// Functions of programs that are evaluated: placeholders before parentheses.
#include "gl/families/known_code.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

const std::vector<std::string> kNames{"code"};

/// A section that knows main and f(), which call functions of any name.
CodeSections calling() {
  CodeSections sections;
  sections["code"].add(
      "vec4 f(vec4 p) { return $map(p) + $map(p) + $other(p); }\nvoid main() { gl_Position = $map(a); }", "",
      true);
  return sections;
}

struct Taken {
  std::string mistake;
  FunctionNames names;
  std::vector<std::string> rest;
};

Taken takenFrom(const std::string& vertex, const std::string& fragment = "") {
  GlslStatements statements;
  statements.cut(vertex, {}, {.wholeMain = true});
  if (!fragment.empty()) statements.cut(fragment, {}, {.wholeMain = true});
  Taken taken;
  const CodeSections sections = calling();
  taken.mistake = takeFunctions(statements, sections, kNames, taken.names);
  for (size_t i = 0; i < statements.size(); ++i) taken.rest.emplace_back(statements[i]);
  EXPECT_EQ(taken.mistake.empty(),
            unknownStatements(statements, sections, kNames).empty() && taken.mistake.empty());
  return taken;
}

const std::string kInner = "vec4 inner(vec4 p) { return 2.0 * p; }\n",
                  kOuter = "vec4 outer(vec4 p) { return inner(p); }\n",
                  kMain = "void main() { gl_Position = outer(a); }\n";

TEST(CalledFunctions, AreTakenWithThoseThatTheyCall) {
  const Taken taken = takenFrom(kInner + kOuter + kMain);
  EXPECT_EQ(taken.mistake, "");
  EXPECT_EQ(taken.names, (FunctionNames{{"$map", "outer"}}));
  EXPECT_EQ(taken.rest, (std::vector<std::string>{"void main(){gl_Position=outer(a);}"}));
}

TEST(CalledFunctions, SeveralPlaceholdersAndShaders) {
  const Taken taken = takenFrom(
      kInner + kOuter + kMain, kInner + kOuter + "vec4 f(vec4 p) { return outer(p) + outer(p) + inner(p); }");
  EXPECT_EQ(taken.mistake, "");
  EXPECT_EQ(taken.names, (FunctionNames{{"$map", "outer"}, {"$other", "inner"}}));
  EXPECT_EQ(taken.rest.size(), 2u);
}

TEST(CalledFunctions, MustBeUnique) {
  EXPECT_EQ(takenFrom(kInner + kOuter + kMain, "vec4 inner(vec4 p) { return 3.0 * p; }").mistake, "outer");
  EXPECT_EQ(takenFrom(kMain).mistake, "outer") << "it is missing";
  EXPECT_EQ(takenFrom(kInner + kOuter + kMain + "vec4 f(vec4 p) { return inner(p) + inner(p) + outer(p); }")
                .mistake,
            "$map");
}

TEST(CalledFunctions, MayNotBeCalledElsewhere) {
  EXPECT_EQ(takenFrom(kInner + kOuter + kMain + "vec4 x = inner(b);").mistake, "inner");
  EXPECT_EQ(takenFrom(kInner + "vec4 outer(vec4 p) { return outer(p); }" + kMain + "vec4 outer = vec4(1.0);")
                .mistake,
            "outer");
}

TEST(CalledFunctions, SectionsWithoutPlaceholdersTakeNone) {
  CodeSections sections;
  sections["code"].add(kInner + kOuter + kMain);
  GlslStatements statements;
  statements.cut(kInner + kOuter + kMain);
  FunctionNames names;
  const size_t before = statements.size();
  EXPECT_EQ(takeFunctions(statements, sections, kNames, names), "");
  EXPECT_EQ(statements.size(), before);
  EXPECT_TRUE(names.empty());
}

}  // namespace
}  // namespace gluray::gl

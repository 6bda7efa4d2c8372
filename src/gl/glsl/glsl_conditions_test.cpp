// Which lines of a GLSL text remain when its conditions are resolved.
#include "gl/glsl/glsl_conditions.h"

#include "gl/glsl/glsl_statements.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

using Lines = std::vector<std::string>;

/// The statements that remain; "unresolved" if a condition cannot be resolved.
Lines left(const std::string& text) {
  const auto rest = resolveConditions(text);
  if (!rest) return {"unresolved"};
  GlslStatements statements;
  statements.cut(*rest);
  Lines lines;
  for (size_t i = 0; i < statements.size(); ++i) lines.emplace_back(statements[i]);
  return lines;
}

TEST(GlslConditions, BranchesByDefinedNames) {
  EXPECT_EQ(left("#ifdef A\nfloat a;\n#else\nfloat b;\n#endif\n"), Lines{"float b;"});
  EXPECT_EQ(left("#define A\n#ifdef A\nfloat a;\n#else\nfloat b;\n#endif"), Lines{"float a;"});
  EXPECT_EQ(left("#define A 1\n#ifndef A // not\nfloat a;\n#endif\nfloat c;"), Lines{"float c;"});
  EXPECT_EQ(left("#define A\n#undef A\n#ifdef A\nfloat a;\n#endif\n").back(), "#undef A");
  EXPECT_EQ(left("#ifdef A\n#define B\n#endif\n#ifdef B\nfloat b;\n#endif\nfloat c;\n"), Lines{"float c;"});
}

TEST(GlslConditions, ExpressionsAndChains) {
  const std::string chain =
      "#if defined(A) || defined B\nfloat one;\n#elif defined(C) && !(defined(D) || defined(E))\nfloat "
      "two;\n#else\nfloat three;\n#endif\n";
  EXPECT_EQ(left("#define B\n#define C\n" + chain), Lines{"float one;"});
  EXPECT_EQ(left("#define C\n" + chain), Lines{"float two;"});
  EXPECT_EQ(left("#define C\n#define E\n" + chain), Lines{"float three;"});
  EXPECT_EQ(left("#ifdef A\n#if X > 2\n#endif\n#endif\nfloat a;"), Lines{"unresolved"})
      << "even where nothing is left";
}

TEST(GlslConditions, ZeroAndOne) {
  EXPECT_EQ(left("#if 1\nfloat a;\n#else\nfloat b;\n#endif\n#if 0\nfloat c;\n#endif\n"), Lines{"float a;"});
  EXPECT_EQ(left("#if !0 && defined(A)\nfloat a;\n#else\nfloat b;\n#endif\n"), Lines{"float b;"});
  EXPECT_EQ(left("#if 2\nfloat a;\n#endif\n"), Lines{"unresolved"});
}

TEST(GlslConditions, NestInEachOther) {
  const std::string nested =
      "#ifdef A\nfloat a;\n#ifdef B\nfloat b;\n#else\nfloat c;\n#endif\n#else\n#ifndef B\nfloat "
      "d;\n#endif\n#endif\n";
  EXPECT_EQ(left("#define A\n#define B\n" + nested), (Lines{"float a;", "float b;"}));
  EXPECT_EQ(left("#define A\n" + nested), (Lines{"float a;", "float c;"}));
  EXPECT_EQ(left("#define B\n" + nested), Lines{});
  EXPECT_EQ(left(nested), Lines{"float d;"});
}

TEST(GlslConditions, StatementsMayHaveThem) {
  EXPECT_EQ(
      left("#define A\nvoid main() { float x = 1.0\n#ifdef A\n + 2.0\n#endif\n; x = /*\n#else\n*/ 3.0; }"),
      (Lines{"float x=1.+2.;", "x=3.;"}));
}

TEST(GlslConditions, DefinitionsThatTheRestUses) {
  EXPECT_EQ(left("#define N 3\n#define M 4\n#define K N\nfloat a[K];\n"),
            (Lines{"#define N 3", "#define K N", "float a[K];"}));
}

TEST(GlslConditions, WhatCannotBeResolved) {
  for (const char* text :
       {"#if 2\n#endif", "#if 1 + 0\n#endif", "#if __VERSION__ > 120\n#endif",
        "#ifdef GL_ARB_texture_rectangle\n#endif", "#ifdef A\n", "#else\n", "#endif\n",
        "#ifdef A\n#else\n#else\n#endif", "#if defined(A\n#endif", "#if defined(A) B\n#endif",
        "#ifdef\n#endif", "#if defined(A) & defined(B)\n#endif", "#elif defined(A)\n#endif"})
    EXPECT_EQ(left(text), Lines{"unresolved"}) << text;
  EXPECT_EQ(left("#ifdef GL_ES\nfloat a;\n#endif\nfloat b;"), Lines{"float b;"});
}

}  // namespace
}  // namespace gluray::gl

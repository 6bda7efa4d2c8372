// GLSL cut into statements: where they end, which are omitted, and which count as equal.
#include "gl/glsl/glsl_statements.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

using Texts = std::vector<std::string>;

/// Cuts an exact-size copy of the text, so that a sanitizer sees reads beyond its end.
Texts cut(const std::string& text) {
  std::vector<char> exact(text.begin(), text.end());
  exact.shrink_to_fit();
  GlslStatements statements;
  statements.cut({exact.data(), exact.size()});
  Texts texts;
  for (size_t i = 0; i < statements.size(); ++i) texts.emplace_back(statements[i]);
  return texts;
}
/// The statements of a main function with the body `text`.
Texts body(const std::string& text) { return cut("void main() {\n" + text + "\n}\n"); }

TEST(GlslStatements, OmitsCommentsAndWhiteSpace) {
  EXPECT_EQ(body("  a /* b */ = // c\n  d\t+ e ;"), Texts{"a=d+e;"});
  EXPECT_EQ(body("vec3   a  =  b . xyz;"), Texts{"vec3 a=b.xyz;"});
  EXPECT_EQ(body("a = b /* not ended"), Texts{"a=b"});
  EXPECT_EQ(body("return\n  a;"), Texts{"return a;"});
  EXPECT_EQ(body("a \\\n = b;"), Texts{"a=b;"});
  EXPECT_EQ(cut(""), Texts{});
}

TEST(GlslStatements, DropsUnusedFunctionsAndConstants) {
  const auto used = [](const std::string& text) {
    GlslStatements statements;
    statements.cut("void main() { before(); }");
    statements.cut(text, {}, {.used = true});
    Texts texts;
    for (size_t i = 1; i < statements.size(); ++i) texts.emplace_back(statements[i]);
    return texts;
  };
  const std::string main = "void main() { a = f(b); }";
  EXPECT_EQ(used("float f(float x) { return x; } " + main),
            (Texts{"float f(float x){return x;}", "a=f(b);"}));
  EXPECT_EQ(used("float g(float x) { return f(x); } float g(); " + main), Texts{"a=f(b);"});
  EXPECT_EQ(used("float h(); float f(float x) { return h(); } " + main + " float h() { return 1.; }").size(),
            4u);
  EXPECT_EQ(used("float i(float x) { return h(x); } float h(float x) { return x; } " + main),
            Texts{"a=f(b);"})
      << "what only an unused function uses";
  EXPECT_EQ(used("const float c = 2.0; " + main), Texts{"a=f(b);"});
  EXPECT_EQ(used("const float b = 2.0; " + main).size(), 2u);
  EXPECT_EQ(used("const float c = 2.0, b = 1.0; " + main).size(), 2u) << "one of several";
  EXPECT_EQ(used("float c = g(1.0); " + main).size(), 2u) << "may have effects";
  EXPECT_EQ(used("void main() { const float c = 2.0; vec2 d(1.0); return f(x); }").size(), 3u)
      << "statements of main stay";
  EXPECT_EQ(used("#define f g\nfloat g(float x) { return x; } " + main).size(), 3u) << "used by a macro";
}

TEST(GlslStatements, RenamesOneName) {
  GlslStatements statements;
  statements.cut("void main() { a = texture(mine, t) + mine2 * b.mine; }", {"mine", "theirs"});
  ASSERT_EQ(statements.size(), 1u);
  EXPECT_EQ(statements[0], "a=texture(theirs,t)+mine2*b.theirs;");
}

TEST(GlslStatements, NumbersHaveOneForm) {
  for (const char* half : {"0.5", ".5", "0.50", ".500f", "00.5", "0.5F"})
    EXPECT_EQ(body(std::string("a=") + half + ";"), Texts{"a=.5;"}) << half;
  for (const char* zero : {"0.0", "0.", ".0", "0.0f", "00.00"})
    EXPECT_EQ(body(std::string("a=") + zero + ";"), Texts{"a=0.;"}) << zero;
  for (const char* two : {"2.0", "2.", "2.00f"})
    EXPECT_EQ(body(std::string("a=") + two + ";"), Texts{"a=2.;"}) << two;
  for (const char* other : {"1e-5", "1.0e5", "10", "0", "0x0F", "2u", "20.25", "65000"})
    EXPECT_EQ(body(std::string("a=") + other + ";"), Texts{std::string("a=") + other + ";"}) << other;
  EXPECT_EQ(body("a=b-1.0;"), Texts{"a=b-1.;"});
  EXPECT_EQ(body("a=v2.x;"), Texts{"a=v2.x;"}) << "a name, not a number";
}

TEST(GlslStatements, ConditionsIncludeTheirBody) {
  EXPECT_EQ(body("if (a) { b = 1; c = 2; } d = 3;"), (Texts{"if(a){b=1;c=2;}", "d=3;"}));
  EXPECT_EQ(body("if (a) { b; }\n else\n { c; } d;"), (Texts{"if(a){b;}else{c;}", "d;"}));
  EXPECT_EQ(body("if (a) b; else if (c) d; else e; f;"), (Texts{"if(a)b;else if(c)d;else e;", "f;"}));
  EXPECT_EQ(body("while (a) { b; } c;"), (Texts{"while(a){b;}", "c;"}));
  EXPECT_EQ(body("do { b; } while (a); c;"), (Texts{"do{b;}while(a);", "c;"}));
  EXPECT_EQ(body("{ a; b; } c;"), (Texts{"{a;b;}", "c;"}));
}

TEST(GlslStatements, LoopBodiesAreCutIntoStatements) {
  EXPECT_EQ(body("for (int i = 0; i < 3; ++i) { a; if (b) c; } d;"),
            (Texts{"for(int i=0;i<3;++i){", "a;", "if(b)c;", "d;"}));
  EXPECT_EQ(body("for (;;) { for (;;) { a; } } b;"), (Texts{"for(;;){", "for(;;){", "a;", "b;"}));
  EXPECT_EQ(body("for (;;) a; b;"), (Texts{"for(;;)a;", "b;"}));
  EXPECT_EQ(body("for (;;) { a; } }\nfloat f() { return 1.0; }\nvoid g() {"),
            (Texts{"for(;;){", "a;", "float f(){return 1.;}", "void g(){}"}))
      << "main has ended";
}

TEST(GlslStatements, FunctionsAreOneStatement) {
  EXPECT_EQ(cut("float f(float x) { if (x > 0.0) { return x; } else { return 1.0; } }\nvec2 g(in vec2 a);"),
            (Texts{"float f(float x){if(x>0.){return x;}else{return 1.;}}", "vec2 g(in vec2 a);"}));
  EXPECT_EQ(cut("void main()\n{\n}\nvoid later() { a; }"), Texts{"void later(){a;}"});
  EXPECT_EQ(cut("struct S { vec3 a; };\nS s;"), (Texts{"struct S{vec3 a;};", "S s;"}));
}

TEST(GlslStatements, OmitsStatementsWithoutEffect) {
  EXPECT_EQ(
      cut("#version 150\n#extension all : enable\n#pragma optimize(on)\n#line 3\nprecision highp float;\n"),
      Texts{});
  EXPECT_EQ(cut("in vec4 a;\nout highp vec3 b[6], c;\nattribute vec3 d;\nvarying vec2 e;\n"), Texts{});
  EXPECT_EQ(cut("uniform mat4 m;\nuniform float a = 3.0;\nlayout(location = 3) uniform vec3 lightColor0;\n"),
            Texts{});
  for (const std::string text : {"flat in int a;", "noperspective out vec4 a[3];", "layout(triangles)in;",
                                 "layout(location=1)out vec4 a;", "uniform B{vec4 a;};", "out B{vec4 a;}b;",
                                 "const float a=1.;", "vec3 a;", "invariant gl_Position;"})
    EXPECT_EQ(cut(text + "\n"), Texts{text});
}

TEST(GlslStatements, DirectivesAreStatementsAnywhere) {
  EXPECT_EQ(cut("#ifdef A\n  # define  B  c // d\n#else // e\n#endif\n"),
            (Texts{"#ifdef A", "#define B c", "#else", "#endif"}));
  EXPECT_EQ(cut("#define A \\\n b\nvec3 c;"), (Texts{"#define A b", "vec3 c;"}));
  EXPECT_EQ(body("a;\n#if 0\nb;\n#endif\n"), (Texts{"a;", "#if 0", "b;", "#endif"}));
  EXPECT_EQ(body("if (a) {\n#ifdef B\nc;\n#endif\n}"), Texts{"if(a){\n#ifdef B\nc;\n#endif\n}"});
  EXPECT_EQ(cut("#define A"), Texts{"#define A"}) << "the text ends with it";
}

TEST(GlslStatements, ReplacesTheNumberOfASingleLight) {
  EXPECT_EQ(body("a += lightColor0 * b;"), Texts{"a+=lightColor#*b;"});
  EXPECT_EQ(body("a += lightColor12 * lightWay12.x + b1;"), Texts{"a+=lightColor#*lightWay#.x+b1;"});
  EXPECT_EQ(body("a += lightColor0 * lightWay1;"), Texts{"a+=lightColor0*lightWay1;"}) << "two lights";
  EXPECT_EQ(body("light1 = lightness;"), Texts{"light#=lightness;"});
}

// Texts whose normal form is longer than they are.
TEST(GlslStatements, NormalFormMayBeLongerThanTheText) {
  EXPECT_EQ(cut("return.0;"), Texts{"return 0.;"});
  EXPECT_EQ(cut("#if !defined(A)\n#endif\n"), (Texts{"#if ! defined(A)", "#endif"}));
  EXPECT_EQ(cut("#if(A)"), Texts{"#if ( A)"});
  EXPECT_EQ(cut("#define A+1"), Texts{"#define A +1"});
  EXPECT_EQ(cut("void f(){\n#ifdef A\n#ifdef B\na;\n#endif\n#endif"),
            Texts{"void f(){\n#ifdef A\n\n#ifdef B\na;\n#endif\n\n#endif\n"});
  EXPECT_EQ(cut("f(){#"), Texts{"f(){#"}) << "not where a line begins";
  EXPECT_EQ(cut("a\n#"), Texts{"a\n#\n"});
}

TEST(GlslStatements, AppendsStatementsOfSeveralTexts) {
  GlslStatements statements;
  statements.cut("void main() { a; for (;;) {"), statements.cut("#define A"), statements.cut("");
  const std::string names(10000, 'b');  // more than there was room for
  statements.cut(names + ";c;");
  ASSERT_EQ(statements.size(), 5u);
  EXPECT_EQ(statements[0], "a;");
  EXPECT_EQ(statements[1], "for(;;){");
  EXPECT_EQ(statements[2], "#define A");
  EXPECT_EQ(statements[3], names + ";");
  EXPECT_EQ(statements[4], "c;");
}

TEST(GlslStatements, ReadsNoTextBeyondItsEnd) {
  for (const char* text : {"}",
                           "}}}",
                           "{",
                           "(",
                           ")",
                           "void main(",
                           "void main() {",
                           "void main() { }",
                           "else",
                           "#",
                           "#\n#",
                           "/",
                           "/*",
                           "//",
                           "\\",
                           "\\\n",
                           ".",
                           "1.",
                           "1e",
                           "0x",
                           "for(",
                           "for(;;){",
                           "a;else b;",
                           ";;;",
                           "return.0;",
                           ".0.0.0",
                           "#if !defined(A)\n#endif\n",
                           "#if(A)",
                           "#define A+1",
                           "#a\n#b\n#c",
                           "f(){\n#ifdef A\n#ifdef B\na=.0;\n#endif\n#endif\n}",
                           "f(){\n#\n#\n#\n#",
                           "\"'@$\x80\xff"}) {
    const std::string spaces(1000, ' ');
    EXPECT_EQ(cut(text), cut(spaces + text)) << text;
    EXPECT_EQ(body(text), body(spaces + text)) << text;
  }
}

TEST(GlslStatements, MainMayBeOneStatement) {
  GlslStatements statements;
  statements.cut("float f() { return 1.0; }\nvoid main() { a = f(); for (;;) { b; } }", {},
                 {.used = true, .wholeMain = true});
  ASSERT_EQ(statements.size(), 2u);
  EXPECT_EQ(statements[1], "void main(){a=f();for(;;){b;}}");
  statements.drop({true, false});
  ASSERT_EQ(statements.size(), 1u);
  EXPECT_EQ(statements[0], "void main(){a=f();for(;;){b;}}");
}

}  // namespace
}  // namespace gluray::gl

// The output of explain and doctor for made-up reports and findings.
#include "doctor/diagnosis.h"
#include "explain/explanation_text.h"
#include "text_table.h"

#include <gtest/gtest.h>

namespace gluray::launcher {
namespace {

using nlohmann::json;

TEST(Text, TablesAreAligned) {
  TextTable table("lrl");
  table.row({"a", "10", "x"});
  table.row({"long", "9", ""});
  EXPECT_EQ(table.text("> "), "> a     10  x\n> long   9\n");
}

TEST(Text, LinesWrapAtBlanks) {
  EXPECT_EQ(wrapped("one two three", 7, "- "), "- one two\n- three\n");
  EXPECT_EQ(wrapped("unbreakable a", 4, ""), "unbreakable\na\n");
  EXPECT_EQ(wrapped("", 4, "  "), "");
}

TEST(Text, NumbersAreGrouped) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1 000");
  EXPECT_EQ(grouped(12345678), "12 345 678");
  EXPECT_EQ(fixed(1.2345, 2), "1.23");
}

json kind(const char* primitive, const char* path, uint64_t count, uint64_t triangles, double ms,
          const char* reason, json state) {
  return {{"primitive", primitive},
          {"path", path},
          {"count", count},
          {"triangles", triangles},
          {"ms", ms},
          {"reason", reason},
          {"state", std::move(state)},
          {"traced", std::string(reason) == "traced"}};
}

/// Ten frames of a viewer.
json report() {
  return {{"program", "viewer"},
          {"pid", 42},
          {"frames", 10},
          {"flushes", 10},
          {"repeated", 3},
          {"door", "vendor"},
          {"triangles", {{"traced", 30000}, {"rasterised", 10000}}},
          {"bvh", {{"builds", 1}}},
          {"ms", {{"capture", 0.5}, {"build", 0.25}, {"trace", 4.0}, {"present", 1.0}}},
          {"unknownCalls", {{"glDrawPixels", 10}, {"glGetString", 3}, {"glIsTexture", 1}}},
          {"explain",
           {{"kinds",
             {kind("lines", "glBegin", 10, 0, 1.0, "lines", json::array()),
              kind("surfaces", "arrays", 20, 10000, 5.0, "blending", {"lighting", "blend"}),
              kind("surfaces", "list", 10, 30000, 2.0, "traced", {"lighting"})}},
            {"contexts",
             {{{"api", "GLX"},
               {"profile", "compatibility"},
               {"doubleBuffered", true},
               {"version", "4.5"},
               {"renderer", "llvmpipe"},
               {"frames", 10},
               {"traced", 10},
               {"rasterised", 30}}}},
            {"framebuffers",
             {{{"name", 0},
               {"width", 640},
               {"height", 480},
               {"samples", 4},
               {"traced", 10},
               {"rasterised", 30}}}},
            {"quirks", {{{"name", "material-latch"}, {"on", true}, {"uses", 3}}}},
            {"unknownFunctions", {"glFooBarXYZ"}}}}};
}

TEST(Text, ExplanationEndsWithWarnings) {
  json warned = report();
  warned["warnings"] = {"gather: rank 1 of the program blends surfaces", "a line\nbreak"};
  EXPECT_EQ(explanationText(warned), explanationText(report()) +
                                         "\nwarnings\n  gather: rank 1 of the program blends surfaces\n"
                                         "  a line\\nbreak\n");
}

TEST(Text, ExplanationHasEveryPart) {
  EXPECT_EQ(explanationText(report()),
            R"(viewer (process 42): 10 frames, 75.0 % of 40 000 triangles traced

draws, of all frames
  what      how      draws  triangles  ms/frame                        state
  surfaces  list        10     30 000     0.200  traced                lighting
  surfaces  arrays      20     10 000     0.500  rasterised: blending  lighting, blend
  lines     glBegin     10          0     0.100  rasterised: lines
  tracing, ms/frame: capture 0.500, build 0.250, trace 4.000, write-back 1.000; 10 batches, 3 of them unchanged, 1 acceleration structures built

contexts, through the door vendor
  GLX, compatibility, double-buffered, 4.5, llvmpipe: 10 frames, 10 draws traced, 30 rasterised

framebuffers
  the window  640 x 480  4 samples, 10 draws traced, 30 rasterised

quirks
  material-latch  on  made a difference 3 times

calls that GLuRay does not model, left to the real OpenGL
  glDrawPixels  10

functions that the program looked up and GLuRay does not know: it does not see calls to them
  glFooBarXYZ
)");
}

TEST(Text, CompositionInTheStencilBufferIsExplained) {
  json composed = report();
  json& kinds = composed["explain"]["kinds"];
  kinds.push_back(kind("surfaces", "glBegin", 4454, 4736, 1.0, "colour mask", {"stencil", "cull"}));
  kinds.push_back(kind("surfaces", "glBegin", 9, 12, 1.0, "colour mask", {"cull"}));
  const std::string text = explanationText(composed);
  EXPECT_NE(text.find("  The program composes surfaces with the stencil buffer"), text.npos) << text;
  EXPECT_NE(text.find("4 454 draws"), text.npos) << text;
  kinds.erase(kinds.size() - 2);
  EXPECT_EQ(explanationText(composed).find("composes"), text.npos);
}

TEST(Text, ProgramsThatDrawNothingAreExplainedToo) {
  json empty = report();
  empty["explain"]["kinds"] = json::array();
  empty["explain"]["framebuffers"] = json::array();
  empty["explain"]["unknownFunctions"] = json::array();
  empty["unknownCalls"] = json::object();
  empty["frames"] = 0;
  empty["triangles"] = {{"traced", 0}, {"rasterised", 0}};
  EXPECT_EQ(tracedPercent(empty), -1);
  const std::string text = explanationText(empty);
  EXPECT_TRUE(text.starts_with("viewer (process 42): 0 frames\n")) << text;
  EXPECT_NE(text.find("none that GLuRay could see"), text.npos);
  EXPECT_EQ(text.find("does not model"), text.npos);
}

TEST(Diagnosis, ExitCodeIsTheWorst) {
  Diagnosis diagnosis;
  EXPECT_EQ(diagnosis.exitCode(), 0);
  diagnosis.ok("a", "well");
  EXPECT_EQ(diagnosis.exitCode(), 0);
  diagnosis.limited("b", "so so", "do b");
  EXPECT_EQ(diagnosis.exitCode(), 1);
  diagnosis.broken("c", "broken");
  diagnosis.ok("d", "well");
  EXPECT_EQ(diagnosis.exitCode(), 2);
  EXPECT_EQ(
      diagnosis.text(),
      "a  ok       well\nb  limited  so so\n            fix: do b\nc  BROKEN   broken\nd  ok       well\n"
      "\nit will not work\n");
  EXPECT_EQ(diagnosis.json()["exitCode"], 2);
  EXPECT_EQ(diagnosis.json()["findings"][1]["fix"], "do b");
}

}  // namespace
}  // namespace gluray::launcher

#include "gl/families/family.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::gl {
namespace {

const std::string kPulling = R"(
[[code]]
name = "all"
statements = "gl_Position = m * v;"
[[family]]
name = "pulls"
match.active = ["positions"]
match.code = "all"
match.decided = { kind = 5, wire = 0 }
vertex.position = "positions"
transform.clip_from_object = "m"
pull.point_ids = "ids"
pull.first_vertex = "first"
)";

/// The error of the family with these lines.
std::string mistakeOfPulling(const std::string& lines) {
  try {
    parseFamilies(kPulling + lines, "f.toml");
  } catch (const FamilyError& e) { return e.what(); }
  return "";
}

TEST(FamilyPulling, IsRead) {
  const FamilyList list = parseFamilies(
      kPulling + "pull.cells = \"cells\"\npull.cells_if = \"mapped\"\nedges.if = \"edged\"\n", "f.toml");
  const Family& f = *list.front();
  EXPECT_TRUE(f.pulling.given());
  EXPECT_EQ(f.pulling.pointIds, "ids");
  EXPECT_EQ(f.pulling.firstVertex, "first");
  EXPECT_EQ(f.pulling.cellsIf, "mapped");
  EXPECT_EQ(f.edgesIf, "edged");
  EXPECT_EQ(f.decided, (DecidedValues{{"kind", 5}, {"wire", 0}}));
  for (const char* const name : {"ids", "first", "cells", "mapped", "edged", "kind", "wire"})
    EXPECT_TRUE(f.mentions(name)) << name;
}

TEST(FamilyPulling, HasItsMistakesNamed) {
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(
      has(mistakeOfPulling("pull.cells = \"cells\"\n"), "pull.cells and pull.cells_if need each other"));
  EXPECT_TRUE(has(mistakeOfPulling("vertex.tangent = \"t\"\n"), "pulled vertices have neither"));
  EXPECT_TRUE(has(mistakeOfPulling("instance.color = \"c\"\n"), "pulled vertices have neither"));
  EXPECT_TRUE(has(mistakeOfPulling("lights.enabled = \"lit\"\n"), "lights.unlit_shows"));
  EXPECT_EQ(mistakeOfPulling("lights.enabled = \"lit\"\nlights.unlit_shows = \"ambient_and_diffuse\"\n"), "");
  std::string text = kPulling;
  text.replace(text.find("match.code = \"all\""), 18, "");
  EXPECT_THROW(parseFamilies(text, "f.toml"), FamilyError);
  text = kPulling;
  text.replace(text.find("kind = 5"), 8, "kind = \"five\"");
  EXPECT_THROW(parseFamilies(text, "f.toml"), FamilyError);
}

}  // namespace
}  // namespace gluray::gl

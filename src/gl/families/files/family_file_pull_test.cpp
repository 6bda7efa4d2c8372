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

TEST(FamilyPulling, DescribesPointsAndLines) {
  const std::string tubes =
      kPulling +
      "pull.lines = true\npull.size = \"wide\"\nedges.unless = \"round\"\nimpostors.shape = \"tubes\"\n"
      "impostors.size = \"w\"\nimpostors.in_pixels = true\nimpostors.longer = 1\n"
      "impostors.viewport = \"port\"\nimpostors.bulge = 0.1\nimpostors.bulge_depth = 1\n"
      "[[family]]\ninherits = \"pulls\"\nname = \"points\"\nmatch.decided = { kind = 1 }\n"
      "pull.vertices_per_cell = 3\npull.lines = false\n";
  const FamilyList list = parseFamilies(tubes, "f.toml");
  const Family &lines = *list[0], &points = *list[1];
  EXPECT_TRUE(lines.pulling.lines && lines.impostors.inPixels);
  EXPECT_EQ(lines.pulling.size, "wide");
  EXPECT_EQ(lines.edgesUnless, "round");
  EXPECT_EQ(lines.impostors.viewport, "port");
  EXPECT_EQ(lines.impostors.longer.constant, std::vector<float>{1});
  for (const char* const name : {"wide", "round", "w", "port"}) EXPECT_TRUE(lines.mentions(name)) << name;
  EXPECT_EQ(points.pulling.verticesPerCell, 3);
  EXPECT_EQ(points.decided, (DecidedValues{{"kind", 1}})) << "replaces what is inherited";
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
  EXPECT_TRUE(has(mistakeOfPulling("pull.vertices_per_cell = 0\n"), "from 1 on"));
  const std::string tubes =
      "impostors.shape = \"tubes\"\nimpostors.bulge = 0.1\nimpostors.bulge_depth = 1\nimpostors.size = "
      "\"w\"\n";
  EXPECT_EQ(mistakeOfPulling(tubes), "");
  EXPECT_TRUE(has(mistakeOfPulling(tubes + "impostors.in_pixels = true\n"), "needs viewport"));
  EXPECT_TRUE(has(mistakeOfPulling(tubes + "impostors.longer = 1\n"), "need in_pixels"));
  EXPECT_TRUE(
      has(mistakeOfPulling("impostors.shape = \"spheres\"\nimpostors.radius = 1\n"), "beads or tubes"));
  std::string text = kPulling;
  text.replace(text.find("match.code = \"all\""), 18, "");
  EXPECT_THROW(parseFamilies(text, "f.toml"), FamilyError);
  text = kPulling;
  text.replace(text.find("kind = 5"), 8, "kind = \"five\"");
  EXPECT_THROW(parseFamilies(text, "f.toml"), FamilyError);
}

}  // namespace
}  // namespace gluray::gl

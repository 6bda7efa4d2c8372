// Family files: keys of impostors.
#include "gl/families/family.h"
#include "gl/testing/test_family_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

using Numbers = std::vector<float>;

TEST(FamilyFile, ImpostorKeys) {
  const Family f = parsed(
      "impostors.shape = \"cylinders\"\nimpostors.radius = \"r\"\nimpostors.axis = "
      "\"a\"\nimpostors.billboards = "
      "\"faces\"\n"
      "impostors.inside = \"i\"\nimpostors.radius_divisor = 2\nimpostors.fades = true\nclip.centers = "
      "true\n");
  EXPECT_EQ(f.impostors.shape, scene::Shape::cylinders);
  EXPECT_EQ(f.impostors.billboards, scene::Impostors::Billboards::faces);
  EXPECT_EQ(f.impostors.radius.uniform, "r");
  EXPECT_EQ(f.impostors.axis, "a");
  EXPECT_EQ(f.impostors.inside.uniform, "i");
  EXPECT_EQ(f.impostors.radiusDivisor.constant, Numbers{2});
  EXPECT_TRUE(f.impostors.fades && f.clipCenters && f.impostors.given());
  EXPECT_TRUE(f.mentions("r") && f.mentions("a") && f.mentions("i"));
  EXPECT_FALSE(parsed().impostors.given());
  EXPECT_NE(mistakeIn("impostors.radius = 1").find("impostors need a shape"), std::string::npos);
  EXPECT_NE(mistakeIn("impostors.shape = \"cubes\"").find("spheres, discs, cylinders"), std::string::npos);
  const std::string sphere = "impostors.shape = \"spheres\"\nimpostors.radius = 1\n";
  EXPECT_EQ(mistakeIn(sphere), "none");
  EXPECT_NE(mistakeIn(sphere + "clip.planes = \"c\"").find("clip.centers"), std::string::npos);
  EXPECT_NE(mistakeIn(sphere + "color.textures = \"t\"").find("neither textures"), std::string::npos);
  EXPECT_NE(mistakeIn("impostors.shape = \"spheres\"").find("needs impostors.radius"), std::string::npos);
  EXPECT_NE(mistakeIn("impostors.shape = \"cylinders\"\nimpostors.radius = 1").find("needs impostors.axis"),
            std::string::npos);
  EXPECT_NE(mistakeIn("impostors.shape = \"spheres\"\nimpostors.billboards = \"faces\"\nimpostors.radius = 1")
                .find("for cylinders only"),
            std::string::npos);
}

TEST(FamilyFile, BeadsAndTubes) {
  const std::string round = "impostors.bulge = \"r\"\nimpostors.bulge_depth = \"s\"\n";
  const Family f = parsed(round +
                          "impostors.shape = \"tubes\"\nimpostors.size = \"w\"\nimpostors.grows = true\n"
                          "impostors.depth_bias = \"o\"\n");
  EXPECT_EQ(f.impostors.shape, scene::Shape::tubes);
  EXPECT_EQ(f.impostors.size.uniform, "w");
  EXPECT_EQ(f.impostors.bulge.uniform, "r");
  EXPECT_EQ(f.impostors.bulgeDepth.uniform, "s");
  EXPECT_EQ(f.impostors.depthBias.uniform, "o");
  EXPECT_TRUE(f.impostors.grows && f.mentions("w") && f.mentions("r") && f.mentions("s") && f.mentions("o"));
  const std::string beads = round + "impostors.shape = \"beads\"\n";
  EXPECT_EQ(mistakeIn(beads), "none");
  EXPECT_EQ(mistakeIn(beads + "impostors.size = \"w\""), "none");
  EXPECT_NE(
      mistakeIn("impostors.shape = \"discs\"\nimpostors.radius = 1\nimpostors.size = 1").find("need size"),
      std::string::npos);
  EXPECT_NE(mistakeIn(round + "impostors.shape = \"tubes\"").find("need size"), std::string::npos);
  EXPECT_NE(mistakeIn("impostors.shape = \"beads\"").find("need bulge"), std::string::npos);
  EXPECT_NE(mistakeIn(beads + "depth.offset = \"o\"").find("impostors.depth_bias"), std::string::npos);
}

TEST(FamilyFile, Splats) {
  const std::string least = "impostors.shape = \"splats\"\nimpostors.radius = \"r\"\n";
  const Family f = parsed(
      least + "impostors.projection = \"pm\"\nimpostors.scale = \"s\"\nimpostors.billboard_scale = \"c\"\n");
  EXPECT_EQ(f.impostors.shape, scene::Shape::splats);
  EXPECT_EQ(f.impostors.projection, "pm");
  EXPECT_EQ(f.impostors.scale.uniform, "s");
  EXPECT_EQ(f.impostors.billboardScale.uniform, "c");
  EXPECT_TRUE(f.mentions("pm") && f.mentions("s") && f.mentions("c"));
  EXPECT_NE(mistakeIn(least).find("need impostors.projection"), std::string::npos);
  const std::string gaussian = least + "impostors.projection = \"pm\"\nimpostors.gaussian = true\n";
  EXPECT_TRUE(parsed(gaussian).impostors.gaussian && !f.impostors.gaussian);
  EXPECT_NE(mistakeIn(gaussian + "impostors.fades = true").find("impostors.gaussian"), std::string::npos);
  const std::string more = least + "impostors.projection = \"pm\"\nimpostors.instances = true\n";
  EXPECT_TRUE(parsed(more).impostors.instances && !f.impostors.instances);
  EXPECT_NE(mistakeIn(more + "match.geometry_shader = true").find("impostors.instances"), std::string::npos);
  const Family outline = parsed(more + "impostors.antialiased = true\nimpostors.outline = 2");
  EXPECT_TRUE(outline.impostors.antialiased && outline.impostors.outline.given() &&
              !f.impostors.outline.given());
  EXPECT_NE(mistakeIn(more + "impostors.outline = 2").find("impostors.outline"), std::string::npos);
  EXPECT_NE(mistakeIn(gaussian + "impostors.antialiased = true").find("impostors.antialiased"),
            std::string::npos);
  const std::string disc = "impostors.shape = \"discs\"\nimpostors.radius = 1\nimpostors.gaussian = true\n";
  EXPECT_NE(mistakeIn(disc).find("impostors.gaussian"), std::string::npos);
  EXPECT_EQ(mistakeIn(disc + "impostors.billboards = \"triangle\""), "none");
  const std::string bead = "impostors.shape = \"beads\"\nimpostors.bulge = 1\nimpostors.bulge_depth = 1\n";
  EXPECT_NE(mistakeIn(bead + "impostors.projection = \"pm\"").find("need impostors.projection"),
            std::string::npos);
  EXPECT_NE(mistakeIn(least + "impostors.projection = \"pm\"\ndepth.offset = 1").find("impostors.depth_bias"),
            std::string::npos);
}

const std::string kSent =
    "impostors.shape = \"spheres\"\nimpostors.billboards = \"sent\"\nimpostors.corners = \"k\"\n"
    "impostors.projection = \"pm\"\ntransform.eye_from_object = \"mv\"\nmatch.code = \"c\"\n";
const std::string kStick =
    "impostors.shape = \"sticks\"\nimpostors.billboards = \"sent\"\nimpostors.corners = \"k\"\n"
    "impostors.projection = \"pm\"\ntransform.eye_from_object = \"mv\"\nmatch.code = \"c\"\n"
    "impostors.radius = \"r\"\n";

TEST(FamilyFile, SentBillboards) {
  const Family f = parsed(kStick +
                          "impostors.end = \"e\"\nimpostors.end_color = \"ec\"\nimpostors.caps = \"c\"\n"
                          "impostors.round_caps = \"rc\"\nimpostors.halves_blend = [\"hb\", 0.5]\n"
                          "impostors.viewer = \"infinite\"\nimpostors.zero_scale_is_one = true\n"
                          "impostors.radius_in_object_space = true\nimpostors.scale = \"s\"\n");
  EXPECT_EQ(f.impostors.shape, scene::Shape::sticks);
  EXPECT_EQ(f.impostors.corners, "k");
  EXPECT_EQ(f.impostors.end, "e");
  EXPECT_EQ(f.impostors.endColor, "ec");
  EXPECT_EQ(f.impostors.caps, "c");
  EXPECT_EQ(f.impostors.roundCaps, "rc");
  ASSERT_EQ(f.impostors.halvesBlend.size(), 2u);
  EXPECT_EQ(f.impostors.halvesBlend[0].uniform, "hb");
  EXPECT_EQ(f.impostors.halvesBlend[1].constant, Numbers{0.5f});
  EXPECT_TRUE(f.impostors.sent && f.impostors.parallelView && f.impostors.radiusInObject);
  EXPECT_TRUE(f.impostors.zeroScaleIsOne && !f.impostors.radiusInPosition);
  EXPECT_TRUE(f.mentions("k") && f.mentions("e") && f.mentions("ec") && f.mentions("rc") && f.mentions("hb"));
  const Family sphere = parsed(kSent + "impostors.radius_in_position = true\n");
  EXPECT_TRUE(sphere.impostors.sent && sphere.impostors.radiusInPosition && !sphere.impostors.parallelView);
}

TEST(FamilyFile, HemispheresWithRadiiInCorners) {
  const Family f = parsed(kSent + "impostors.radius_in_corners = true\nimpostors.hemispheres = true\n");
  EXPECT_TRUE(f.impostors.radiusInCorners && f.impostors.hemispheres && !f.impostors.radiusInPosition);
  const Family other = parsed(kSent + "impostors.radius_in_position = true\n");
  EXPECT_FALSE(other.impostors.radiusInCorners || other.impostors.hemispheres);
}

TEST(FamilyFile, MistakesInSentBillboards) {
  const auto has = [](const std::string& line, const char* text) {
    EXPECT_NE(mistakeIn(line).find(text), std::string::npos) << mistakeIn(line);
  };
  const auto without = [](std::string text, const std::string& key) {
    const size_t at = text.find(key);
    return text.erase(at, text.find('\n', at) + 1 - at);
  };
  const std::string inPosition = "impostors.radius_in_position = true\n", end = "impostors.end = \"e\"\n";
  EXPECT_EQ(mistakeIn(kSent + inPosition), "none");
  EXPECT_EQ(mistakeIn(kStick + end), "none");
  has(kSent, "needs impostors.radius");
  has(without(kSent + inPosition, "impostors.corners"), "sent billboards need impostors.corners");
  has(without(kSent + inPosition, "impostors.projection"), "need impostors.projection");
  has(without(kSent + inPosition, "transform.eye"), "need transform.eye_from_object");
  has(without(kSent + inPosition, "match.code"), "sent billboards need match.code");
  has(without(kSent + inPosition, "impostors.billboards"), "impostors.projection");
  has(kSent + inPosition + end, "are for sticks alone");
  has(kStick, "sticks need impostors.end");
  has(without(kStick + end, "impostors.billboards"), "need impostors.projection");
  has(kSent + inPosition + "match.geometry_shader = true", "neither geometry shaders");
  has(kSent + inPosition + "impostors.viewer = \"here\"", "origin, infinite");
  const std::string inCorners = "impostors.radius_in_corners = true\n",
                    half = "impostors.hemispheres = true\n";
  EXPECT_EQ(mistakeIn(kSent + inCorners + half), "none");
  has(kStick + end + half, "are for spheres alone");
  has(kStick + end + inCorners, "are for spheres alone");
  has(kSent + inCorners + inPosition, "radius_in_corners replaces");
  has(kSent + inCorners + "impostors.radius = 1\n", "radius_in_corners replaces");
  has(kSent + inCorners + half + "impostors.viewer = \"infinite\"\n", "hemispheres have no");
  has("impostors.shape = \"spheres\"\nimpostors.radius = 1\n" + half, "need ");
  has("impostors.shape = \"spheres\"\nimpostors.radius = 1\n" + inCorners, "need ");
  has("impostors.shape = \"spheres\"\nimpostors.radius = 1\nimpostors.corners = \"k\"\n", "need ");
}

TEST(FamilyFile, LineKeys) {
  const Family f = parsed("match.only_lines_and_points = true\nlines.size = \"wide\"\n");
  EXPECT_EQ(f.lineSize.uniform, "wide");
  EXPECT_TRUE(f.drawsLines() && f.mentions("wide"));
  EXPECT_FALSE(parsed().drawsLines());
  EXPECT_NE(mistakeIn("lines.size = \"wide\"").find("lines.size needs match.only_lines_and_points"),
            std::string::npos);
  EXPECT_EQ(mistakeIn("lines.width = 1"), "x.toml:6: unknown key \"width\"");
}

}  // namespace
}  // namespace gluray::gl

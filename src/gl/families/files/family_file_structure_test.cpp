// Family files as a whole: inheritance, sections, and the message of every mistake.
#include "gl/families/family.h"
#include "gl/testing/test_family_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

using Numbers = std::vector<float>;

TEST(FamilyFile, InheritsAndReplaces) {
  const FamilyList all = parseFamilies(
      "[[family]]\nname = \"first\"\nmatch.active = [\"a\", \"b\"]\nvertex.position = \"a\"\n"
      "transform.clip_from_object = [\"b\", \"c\"]\nmaterial.opacity = \"o\"\npass.does = \"peel\"\n"
      "[[family]]\nname = \"second\"\ninherits = \"first\"\nmatch.active = [\"d\"]\nmaterial.opacity = 0.5\n",
      "x.toml");
  ASSERT_EQ(all.size(), 2u);
  const Family& f = *all[1];
  EXPECT_EQ(f.name, "second");
  EXPECT_EQ(f.active, std::vector<std::string>{"d"});
  EXPECT_EQ(f.position, "a");
  EXPECT_EQ(f.clipFromObject, (std::vector<std::string>{"b", "c"}));
  EXPECT_TRUE(f.material.opacity.uniform.empty());
  EXPECT_EQ(f.material.opacity.constant, Numbers{0.5f});
  EXPECT_EQ(f.pass, Family::Pass::peel);
  EXPECT_TRUE(f.mentions("c"));
}

TEST(FamilyFile, InheritsOnlyFromEarlierFamilies) {
  EXPECT_EQ(mistakeIn("inherits = \"ghost\""), "x.toml:6: there is no family \"ghost\" before this one");
}

TEST(FamilyFile, PassKeys) {
  const Family f = parsed(
      "pass.does = \"fxaa\"\npass.input = \"pi\"\npass.texel = \"pt\"\n"
      "pass.relative_contrast = \"rc\"\npass.hard_contrast = 0.5\n"
      "pass.subpixel_blend_limit = \"sb\"\npass.subpixel_contrast = \"sc\"\n"
      "pass.endpoint_search_iterations = 12\n");
  EXPECT_EQ(f.pass, Family::Pass::fxaa);
  EXPECT_EQ(f.passInput, "pi");
  EXPECT_EQ(f.passTexel, "pt");
  EXPECT_EQ(f.relativeContrast.uniform, "rc");
  EXPECT_EQ(f.hardContrast.constant, Numbers{0.5f});
  EXPECT_EQ(f.subpixelBlendLimit.uniform, "sb");
  EXPECT_EQ(f.subpixelContrast.uniform, "sc");
  EXPECT_EQ(f.endpointSearchIterations.constant, Numbers{12});
  EXPECT_EQ(mistakeIn("pass.does = \"blur\""),
            "x.toml:6: does must be one of: fxaa, peel_depths, peel, peel_rest, sum, resolve");
}

TEST(FamilyFile, AcceptsDottedKeysAndSections) {
  const FamilyList list = parseFamilies(
      "[[family]]\nname = \"f\"\n[family.match]\nactive = [\"p\"]\n[family.vertex]\nposition = \"p\"\n"
      "[family.transform]\nclip_from_object = \"m\"\n[[family]]\nname = \"g\"\nmatch.any = \"q\"\n"
      "match.rasterise = \"never\"\n",
      "x.toml");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0]->position, "p");
  EXPECT_EQ(list[1]->name, "g");
}

TEST(FamilyFile, AnEmptyFileHasNoFamilies) { EXPECT_TRUE(parseFamilies("# nothing\n", "x.toml").empty()); }

TEST(FamilyFile, PatternsMentionNamesWithNumbers) {
  const Family f = parsed(
      "lights.color = \"lightColor{}\"\nlights.direction = \"set2_light{}_way\"\nlights.position = "
      "\"place[{}]\"\n");
  for (const char* name :
       {"lightColor{}", "lightColor0", "lightColor17", "set2_light3_way", "place", "place[2]"})
    EXPECT_TRUE(f.mentions(name)) << name;
  for (const char* name :
       {"lightColor", "lightColor0x", "lightColour0", "set2_light_way", "set_light2_way", "0", ""})
    EXPECT_FALSE(f.mentions(name)) << name;
}

TEST(FamilyFile, EveryMistakeHasItsLine) {
  EXPECT_EQ(mistake("[[family]]\nmatch.active = [\"p\"]\n"), "x.toml:1: a family needs a name");
  EXPECT_EQ(mistake("# one\n[[family]]\nname = \"f\"\n"),
            "x.toml:2: family \"f\" needs match.active or match.any");
  EXPECT_EQ(
      mistake("[[family]]\nname = \"f\"\nmatch.active = \"p\"\n"),
      "x.toml:1: family \"f\" needs vertex.position and transform.clip_from_object, or match.rasterise");
  EXPECT_EQ(mistake("[[family]]\nname = 3\n"), "x.toml:2: name must be a text in quotes");
  EXPECT_EQ(mistakeIn("matsch.active = [\"p\"]"), "x.toml:6: unknown key \"matsch\"");
  EXPECT_EQ(mistakeIn("lights.colour = \"p\""), "x.toml:6: unknown key \"colour\"");
  EXPECT_EQ(mistakeIn("lights = 3"), "x.toml:6: lights must be a section");
  EXPECT_EQ(mistakeIn("match.strict = \"yes\""), "x.toml:6: strict must be true or false");
  EXPECT_EQ(mistakeIn("match.absent = [\"a\", 3]"), "x.toml:6: absent must be texts in quotes");
  EXPECT_EQ(mistakeIn("vertex.normal = true"),
            "x.toml:6: normal must be a name in quotes, or a list of such names");
  EXPECT_EQ(mistakeIn("material.opacity = true"),
            "x.toml:6: opacity must be a uniform's name, a number or a list of numbers");
  EXPECT_EQ(mistakeIn("material.diffuse_color = [1, \"r\"]"),
            "x.toml:6: diffuse_color must be a uniform's name, a number or a list of numbers");
  EXPECT_EQ(mistakeIn("material.diffuse_color = []"), "x.toml:6: diffuse_color must have 1 to 4 numbers");
  EXPECT_EQ(mistakeIn("material.diffuse_color = [1, 2, 3, 4, 5]"),
            "x.toml:6: diffuse_color must have 1 to 4 numbers");
  EXPECT_EQ(mistakeIn("lights.model = \"toon\""), "x.toml:6: model must be one of: unlit, phong, pbr");
  EXPECT_EQ(mistakeIn("lights.specular = \"none\""), "x.toml:6: specular must be one of: reflect, half");
  EXPECT_EQ(mistakeIn("normals.without = \"guess\""), "x.toml:6: without must be one of: refuse, triangle");
  EXPECT_EQ(mistake("familie = 3\n"), "x.toml:1: only [[family]] and [[code]] sections are expected here");
  EXPECT_EQ(mistake("family = 3\n"), "x.toml:1: only [[family]] and [[code]] sections are expected here");
  EXPECT_EQ(mistake("family = [3]\n"), "x.toml:1: family must be a section");
  EXPECT_EQ(mistakeIn("clip = = 1").rfind("x.toml:6: ", 0), 0u) << "not TOML at all";
  EXPECT_EQ(mistakeIn("name = \"twice\"").rfind("x.toml:6: ", 0), 0u) << "TOML has each key once";
}

TEST(FamilyFile, BuiltInFamiliesExist) {
  const FamilyList& all = builtInFamilies();
  EXPECT_GE(all.size(), 8u);
  for (const auto& family : all) EXPECT_FALSE(family->name.empty());
}

}  // namespace
}  // namespace gluray::gl

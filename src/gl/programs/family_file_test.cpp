// Family files: what every key does, and what is said of every mistake.
#include "gl/programs/family.h"
#include "gl/programs/test_family_text.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::gl {
namespace {

Family parsed(const std::string& more = "") {
  const FamilyList list = parseFamilies(kLeast + more, "x.toml");
  EXPECT_EQ(list.size(), 1u);
  return *list.at(0);
}

std::string mistakeIn(const std::string& line) { return mistake(kLeast + line + "\n"); }

using Names = std::vector<std::string>;
using Numbers = std::vector<float>;

TEST(FamilyFile, TheLeastThereCanBe) {
  const Family f = parsed();
  EXPECT_EQ(f.name, "f");
  EXPECT_EQ(f.active, (Names{"p", "m"}));
  EXPECT_EQ(f.position, "p");
  EXPECT_EQ(f.clipFromObject, Names{"m"});
  EXPECT_TRUE(f.strict);
  EXPECT_TRUE(f.rasteriseBecause.empty());
  EXPECT_EQ(f.model, Family::Model::phong);
  EXPECT_EQ(f.specular, Family::Specular::reflect);
  EXPECT_EQ(f.withoutNormals, Family::NoNormals::refuse);
  EXPECT_FALSE(f.material.given() || f.backMaterial.given() || f.pbr.given());
  EXPECT_EQ(f.mentioned, (std::set<std::string, std::less<>>{"p", "m"}));
}

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
                .find("those of cylinders"),
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
  EXPECT_NE(mistakeIn(beads + "impostors.size = 1").find("need size"), std::string::npos);
  EXPECT_NE(mistakeIn(round + "impostors.shape = \"tubes\"").find("need size"), std::string::npos);
  EXPECT_NE(mistakeIn("impostors.shape = \"beads\"").find("need bulge"), std::string::npos);
  EXPECT_NE(mistakeIn(beads + "depth.offset = \"o\"").find("impostors.depth_bias"), std::string::npos);
}

TEST(FamilyFile, WhereANameStandsItsAlternativesMayStandToo) {
  const Family f = parsed(
      "vertex.normal = [\"n\", \"normal\", \"n3\"]\nmaterial.opacity = [\"o\", \"alpha\"]\n"
      "transform.eye_from_object = [\"v\", [\"w\", \"world\"]]\nmatch.ignored = [[\"i\", \"j\"]]\n");
  EXPECT_EQ(f.normal, "n");
  EXPECT_EQ(f.material.opacity.uniform, "o");
  EXPECT_EQ(f.eyeFromObject, (Names{"v", "w"}));
  EXPECT_EQ(f.ignored, Names{"i"});
  const Alternatives expected{{"n", {"normal", "n3"}}, {"o", {"alpha"}}, {"w", {"world"}}, {"i", {"j"}}};
  EXPECT_EQ(f.alternatives, expected);
  EXPECT_FALSE(f.mentions("alpha")) << "only in place of what it stands for";
  EXPECT_EQ(mistakeIn("lights.color = [\"l{}\", \"k{}\"]"),
            "x.toml:6: color: names with {} have no alternatives");
  EXPECT_EQ(mistakeIn("vertex.normal = [\"n\", 3]"),
            "x.toml:6: normal must be a name in quotes, or a list of such names");
}

TEST(FamilyFile, NeutralValues) {
  const Family f = parsed("match.neutral = { one = 1, v = [1, 0.5], m = \"identity\" }\n");
  EXPECT_EQ(f.neutral, (NeutralValues{{"one", {1}}, {"v", {1, 0.5f}}, {"m", {}}}));
  EXPECT_TRUE(f.mentions("one") && f.mentions("v") && f.mentions("m"));
  EXPECT_EQ(mistakeIn("match.neutral = 1"), "x.toml:6: neutral must be a section");
  EXPECT_EQ(mistakeIn("match.neutral.m = \"unit\""),
            "x.toml:6: m must be \"identity\", a number or a list of numbers");
  EXPECT_EQ(mistakeIn("match.neutral.m = []"), "x.toml:6: m has 1 to 16 numbers");
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
  const std::string bead = "impostors.shape = \"beads\"\nimpostors.bulge = 1\nimpostors.bulge_depth = 1\n";
  EXPECT_NE(mistakeIn(bead + "impostors.projection = \"pm\"").find("need impostors.projection"),
            std::string::npos);
  EXPECT_NE(mistakeIn(least + "impostors.projection = \"pm\"\ndepth.offset = 1").find("impostors.depth_bias"),
            std::string::npos);
}

TEST(FamilyFile, MatchKeys) {
  const Family f = parsed(
      "match.any = \"a\"\nmatch.absent = [\"b\", \"c\"]\nmatch.absent_outputs = \"o\"\nmatch.ignored = "
      "[\"i\"]\n"
      "match.strict = false\nmatch.rasterise = \"why\"\n");
  EXPECT_EQ(f.any, Names{"a"});
  EXPECT_EQ(f.absent, (Names{"b", "c"}));
  EXPECT_EQ(f.absentOutputs, Names{"o"});
  EXPECT_EQ(f.ignored, Names{"i"});
  EXPECT_FALSE(f.strict);
  EXPECT_EQ(f.rasteriseBecause, "why");
  EXPECT_TRUE(f.mentions("a") && f.mentions("i"));
  EXPECT_FALSE(f.mentions("b")) << "what must be absent is not known";
}

TEST(FamilyFile, VertexAndTransformKeys) {
  const Family f = parsed(
      "vertex.normal = \"n\"\nvertex.color = \"c\"\nvertex.texcoord = \"t\"\n"
      "transform.eye_from_object = [\"v\", \"w\"]\ntransform.viewer = \"eye\"\ntransform.normal_matrix = "
      "\"nm\"\n");
  EXPECT_EQ(f.normal, "n");
  EXPECT_EQ(f.color, "c");
  EXPECT_EQ(f.texcoord, "t");
  EXPECT_EQ(f.eyeFromObject, (Names{"v", "w"}));
  EXPECT_EQ(f.viewer, "eye");
  EXPECT_EQ(f.normalMatrix, "nm");
  for (const char* name : {"n", "c", "t", "v", "w", "eye", "nm"}) EXPECT_TRUE(f.mentions(name)) << name;
}

TEST(FamilyFile, NormalAndColourKeys) {
  const Family f = parsed(
      "normals.without = \"triangle\"\nnormals.flip_back_faces = true\nnormals.parallel_view = \"pv\"\n"
      "normals.per_triangle = \"tn\"\ncolor.map = \"cm\"\ncolor.per_triangle = \"tc\"\n"
      "color.triangle_offset = \"to\"\ncolor.uniform_instead = \"ui\"\ncolor.diffuse_only = true\n"
      "color.textures = [\"t1\", \"t2\"]\ncolor.any_texture = \"t2\"\ncolor.map_texcoord = "
      "\"mt\"\ncolor.texcoord_matrix = \"tm\"\n");
  EXPECT_EQ(f.mapTexcoord, "mt");
  EXPECT_EQ(f.texcoordMatrix, "tm");
  EXPECT_EQ(f.withoutNormals, Family::NoNormals::triangle);
  EXPECT_TRUE(f.flipBackFaces);
  EXPECT_EQ(f.parallelView, "pv");
  EXPECT_EQ(f.triangleNormals, "tn");
  EXPECT_EQ(f.colorMap, "cm");
  EXPECT_EQ(f.triangleColors, "tc");
  EXPECT_EQ(f.triangleOffset, "to");
  EXPECT_EQ(f.uniformColors, "ui");
  EXPECT_TRUE(f.colorIsDiffuseOnly);
  EXPECT_EQ(f.textures, (Names{"t1", "t2"}));
  EXPECT_EQ(f.anyTexture, "t2");
  EXPECT_EQ(mistakeIn("color.textures = \"t1\"\ncolor.any_texture = \"t3\"\n"),
            "x.toml:7: any_texture is none of the textures");
  for (const char* name : {"pv", "tn", "cm", "tc", "to", "ui", "t1", "t2"})
    EXPECT_TRUE(f.mentions(name)) << name;
}

void expectMaterial(const FamilyMaterial& m, const std::string& prefix) {
  EXPECT_EQ(m.ambientIntensity.uniform, prefix + "ai");
  EXPECT_EQ(m.ambientColor.constant, (Numbers{0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(m.diffuseIntensity.constant, Numbers{1});
  EXPECT_EQ(m.diffuseColor.uniform, prefix + "dc");
  EXPECT_EQ(m.specularIntensity.constant, Numbers{0.5f});
  EXPECT_EQ(m.specularColor.uniform, prefix + "sc");
  EXPECT_EQ(m.shininess.constant, Numbers{20});
  EXPECT_EQ(m.opacity.uniform, prefix + "o");
  EXPECT_TRUE(m.given());
}

std::string materialText(const std::string& section, const std::string& prefix) {
  return section + ".ambient_intensity = \"" + prefix + "ai\"\n" + section +
         ".ambient_color = [0.1, 0.2, 0.3]\n" + section + ".diffuse_intensity = 1\n" + section +
         ".diffuse_color = \"" + prefix + "dc\"\n" + section + ".specular_intensity = 0.5\n" + section +
         ".specular_color = \"" + prefix + "sc\"\n" + section + ".shininess = 20\n" + section +
         ".opacity = \"" + prefix + "o\"\n";
}

TEST(FamilyFile, MaterialKeysOfBothFaces) {
  const Family f = parsed(materialText("material", "f") + materialText("back_material", "b"));
  expectMaterial(f.material, "f");
  expectMaterial(f.backMaterial, "b");
  EXPECT_TRUE(f.mentions("fdc") && f.mentions("bo"));
}

TEST(FamilyFile, LightKeys) {
  const Family f = parsed(
      "lights.model = \"unlit\"\nlights.specular = \"half\"\nlights.count = \"n\"\nlights.color = \"c{}\"\n"
      "lights.direction = \"d{}\"\nlights.direction_towards_light = true\nlights.position = \"p[{}]\"\n"
      "lights.positional = \"l[{}].is\"\nlights.attenuation = \"a{}\"\nlights.cone_angle = \"k{}\"\n"
      "lights.exponent = \"e{}\"\nlights.headlight = \"viewer\"\n");
  EXPECT_EQ(f.lights.headlight, FamilyLights::Headlight::viewer);
  EXPECT_EQ(f.model, Family::Model::unlit);
  EXPECT_EQ(f.specular, Family::Specular::half);
  EXPECT_EQ(f.lights.count, "n");
  EXPECT_EQ(f.lights.color, "c{}");
  EXPECT_EQ(f.lights.direction, "d{}");
  EXPECT_TRUE(f.lights.towardsLight);
  EXPECT_EQ(f.lights.position, "p[{}]");
  EXPECT_EQ(f.lights.positional, "l[{}].is");
  EXPECT_EQ(f.lights.attenuation, "a{}");
  EXPECT_EQ(f.lights.coneAngle, "k{}");
  EXPECT_EQ(f.lights.exponent, "e{}");
}

TEST(FamilyFile, PbrClipAndDepthKeys) {
  const Family f = parsed(
      "lights.model = \"pbr\"\npbr.metallic = \"m1\"\npbr.roughness = 0.25\npbr.base_f0 = \"b0\"\n"
      "pbr.edge_tint = [1, 2, 3]\npbr.emissive = \"em\"\nclip.planes = \"cp\"\n"
      "clip.count = \"cn\"\ndepth.offset = \"do\"\ndepth.factor = 2\n");
  EXPECT_EQ(f.model, Family::Model::pbr);
  EXPECT_EQ(f.pbr.metallic.uniform, "m1");
  EXPECT_EQ(f.pbr.roughness.constant, Numbers{0.25f});
  EXPECT_EQ(f.pbr.baseF0.uniform, "b0");
  EXPECT_EQ(f.pbr.edgeTint.constant, (Numbers{1, 2, 3}));
  EXPECT_EQ(f.pbr.emissive.uniform, "em");
  EXPECT_EQ(f.clipPlanes, "cp");
  EXPECT_EQ(f.clipPlaneCount, "cn");
  EXPECT_EQ(f.depthOffset.uniform, "do");
  EXPECT_EQ(f.depthFactor.constant, Numbers{2});
}

TEST(FamilyFile, InstanceAndEdgeKeys) {
  const Family f = parsed(
      "match.geometry_shader = true\ninstance.transform = \"it\"\ninstance.normal_matrix = \"in\"\n"
      "instance.color = \"ic\"\nedges.flags = \"ef\"\nedges.width = 2\nedges.color = \"ec\"\n"
      "edges.opacity = \"eo\"\nedges.corners = \"stay\"\n");
  EXPECT_EQ(f.edgeOpacity.uniform, "eo");
  EXPECT_FALSE(f.edgesGrow);
  EXPECT_TRUE(parsed().edgesGrow);
  EXPECT_TRUE(f.geometryShader);
  EXPECT_EQ(f.instanceTransform, "it");
  EXPECT_EQ(f.instanceNormal, "in");
  EXPECT_EQ(f.instanceColor, "ic");
  EXPECT_EQ(f.edgeFlags, "ef");
  EXPECT_EQ(f.edgeWidth.constant, Numbers{2});
  EXPECT_EQ(f.edgeColor.uniform, "ec");
  for (const char* name : {"it", "in", "ic", "ef", "ec"}) EXPECT_TRUE(f.mentions(name)) << name;
}

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

TEST(FamilyFile, InheritsFromWhatIsThere) {
  EXPECT_EQ(mistakeIn("inherits = \"ghost\""), "x.toml:6: there is no family \"ghost\" before this one");
}

TEST(FamilyFile, PassKeys) {
  const Family f = parsed(
      "pass.does = \"fxaa\"\npass.input = \"pi\"\npass.relative_contrast = \"rc\"\npass.hard_contrast = 0.5\n"
      "pass.subpixel_blend_limit = \"sb\"\npass.subpixel_contrast = \"sc\"\n"
      "pass.endpoint_search_iterations = 12\n");
  EXPECT_EQ(f.pass, Family::Pass::fxaa);
  EXPECT_EQ(f.passInput, "pi");
  EXPECT_EQ(f.relativeContrast.uniform, "rc");
  EXPECT_EQ(f.hardContrast.constant, Numbers{0.5f});
  EXPECT_EQ(f.subpixelBlendLimit.uniform, "sb");
  EXPECT_EQ(f.subpixelContrast.uniform, "sc");
  EXPECT_EQ(f.endpointSearchIterations.constant, Numbers{12});
  EXPECT_EQ(mistakeIn("pass.does = \"blur\""),
            "x.toml:6: does must be one of: fxaa, peel_depths, peel, peel_rest, sum, resolve");
}

TEST(FamilyFile, SectionsMayBeWrittenInEitherWay) {
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

TEST(FamilyFile, NamesWithNumbersAreMentionedByTheirPattern) {
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
  EXPECT_EQ(mistakeIn("material.diffuse_color = []"), "x.toml:6: diffuse_color has 1 to 4 numbers");
  EXPECT_EQ(mistakeIn("material.diffuse_color = [1, 2, 3, 4, 5]"),
            "x.toml:6: diffuse_color has 1 to 4 numbers");
  EXPECT_EQ(mistakeIn("lights.model = \"toon\""), "x.toml:6: model must be one of: unlit, phong, pbr");
  EXPECT_EQ(mistakeIn("lights.specular = \"none\""), "x.toml:6: specular must be one of: reflect, half");
  EXPECT_EQ(mistakeIn("normals.without = \"guess\""), "x.toml:6: without must be one of: refuse, triangle");
  EXPECT_EQ(mistake("familie = 3\n"), "x.toml:1: only [[family]] and [[code]] sections are expected here");
  EXPECT_EQ(mistake("family = 3\n"), "x.toml:1: only [[family]] and [[code]] sections are expected here");
  EXPECT_EQ(mistake("family = [3]\n"), "x.toml:1: family must be a section");
  EXPECT_EQ(mistakeIn("clip = = 1").rfind("x.toml:6: ", 0), 0u) << "not TOML at all";
  EXPECT_EQ(mistakeIn("name = \"twice\"").rfind("x.toml:6: ", 0), 0u) << "TOML has each key once";
}

TEST(FamilyFile, TheBuiltInOnesAreThere) {
  const FamilyList& all = builtInFamilies();
  EXPECT_GE(all.size(), 8u);
  for (const auto& family : all) EXPECT_FALSE(family->name.empty());
}

}  // namespace
}  // namespace gluray::gl

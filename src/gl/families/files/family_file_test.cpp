// Family files: keys of surfaces.
#include "gl/families/family.h"
#include "gl/testing/test_family_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

using Names = std::vector<std::string>;
using Numbers = std::vector<float>;

TEST(FamilyFile, SmallestFamilyHasDefaults) {
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

TEST(FamilyFile, NamesMayHaveAlternatives) {
  const Family f = parsed(
      "vertex.normal = [\"n\", \"normal\", \"n3\"]\nmaterial.opacity = [\"o\", \"alpha\"]\n"
      "transform.eye_from_object = [\"v\", [\"w\", \"world\"]]\nmatch.ignored = [[\"i\", \"j\"]]\n");
  EXPECT_EQ(f.normal, "n");
  EXPECT_EQ(f.material.opacity.uniform, "o");
  EXPECT_EQ(f.eyeFromObject, (Names{"v", "w"}));
  EXPECT_EQ(f.ignored, Names{"i"});
  const Alternatives expected{{"n", {"normal", "n3"}}, {"o", {"alpha"}}, {"w", {"world"}}, {"i", {"j"}}};
  EXPECT_EQ(f.alternatives, expected);
  EXPECT_FALSE(f.mentions("alpha")) << "an alternative only replaces its name";
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
  EXPECT_EQ(mistakeIn("match.neutral.m = []"), "x.toml:6: m must have 1 to 16 numbers");
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
  EXPECT_FALSE(f.mentions("b")) << "names in match.absent are not mentioned";
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
  const Family more = parsed(
      "vertex.normal = \"n\"\nnormals.unit = \"both\"\ncolor.from_normals = true\ncolor.clamped = "
      "true\ncolor.opaque_only = true\ncolor.not_negative = true\n");
  EXPECT_EQ(more.unitNormals, scene::FragmentShading::UnitNormals::both);
  EXPECT_TRUE(more.normalColors && more.clampedColors && more.opaqueColors && more.colorsFromZero);
  EXPECT_EQ(f.unitNormals, scene::FragmentShading::UnitNormals::pixels);
  EXPECT_FALSE(f.normalColors || f.clampedColors || f.opaqueColors || f.colorsFromZero);
  EXPECT_EQ(
      mistakeIn("normals.unit = \"vertices\""),
      "x.toml:1: family \"f\": normals.unit, normals.face_viewer, color.from_normals and color.rim are for "
      "vertex normals alone");
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
  EXPECT_EQ(f.lights.direction.uniform, "d{}");
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
      "edges.opacity = \"eo\"\nedges.corners = \"stay\"\nedges.alone = true\n");
  EXPECT_EQ(f.edgeOpacity.uniform, "eo");
  EXPECT_FALSE(f.edgesGrow);
  EXPECT_TRUE(parsed().edgesGrow);
  EXPECT_TRUE(f.edgesAlone && !parsed().edgesAlone);
  EXPECT_TRUE(f.geometryShader);
  EXPECT_EQ(f.instanceTransform, "it");
  EXPECT_EQ(f.instanceNormal, "in");
  EXPECT_EQ(f.instanceColor, "ic");
  EXPECT_EQ(f.edgeFlags, "ef");
  EXPECT_EQ(f.edgeWidth.constant, Numbers{2});
  EXPECT_EQ(f.edgeColor.uniform, "ec");
  for (const char* name : {"it", "in", "ic", "ef", "ec"}) EXPECT_TRUE(f.mentions(name)) << name;
}

}  // namespace
}  // namespace gluray::gl

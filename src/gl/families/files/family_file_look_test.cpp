// Family files: keys of fog, of light highlights and of back faces.
#include "gl/families/components.h"
#include "gl/families/family.h"
#include "gl/testing/test_family_text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::gl {
namespace {

using Numbers = std::vector<float>;
const std::string kEye = "transform.eye_from_object = \"v\"\n", kPaint = "vertex.color = \"c\"\n";

TEST(FamilyFileLook, FogKeys) {
  const Family f =
      parsed(kEye + "fog.color = \"bg\"\nfog.end = \"fe\"\nfog.scale = \"fs\"\nfog.extrapolated = true\n");
  EXPECT_TRUE(f.fog.given() && f.fog.extrapolated);
  EXPECT_EQ(f.fog.mode, scene::Fog::linear);
  EXPECT_EQ(f.fog.color.uniform, "bg");
  EXPECT_EQ(f.fog.end.uniform, "fe");
  EXPECT_EQ(f.fog.scale.uniform, "fs");
  for (const char* name : {"bg", "fe", "fs"}) EXPECT_TRUE(f.mentions(name)) << name;
  const Family range =
      parsed(kEye + "fog.color = [1, 0, 0]\nfog.start = \"range.r\"\nfog.end = \"range.g\"\n");
  EXPECT_EQ(range.fog.color.constant, (Numbers{1, 0, 0}));
  EXPECT_EQ(range.fog.start.uniform, "range.r");
  EXPECT_TRUE(range.mentions("range")) << "a component mentions its vector";
  EXPECT_FALSE(range.fog.extrapolated);
  const Family exp2 = parsed(kEye + "fog.mode = \"exp2\"\nfog.color = 0\nfog.density = 2\n");
  EXPECT_EQ(exp2.fog.mode, scene::Fog::exp2);
  EXPECT_EQ(exp2.fog.density.constant, Numbers{2});
  EXPECT_FALSE(parsed().fog.given());
}

TEST(FamilyFileLook, FogMistakes) {
  const auto inFog = [](const std::string& lines) { return mistake(kMin + kEye + lines); };
  EXPECT_EQ(inFog("fog.end = 1\n"), "x.toml:7: fog needs a color");
  EXPECT_EQ(inFog("fog.color = 1\nfog.end = 1\n"), "x.toml:7: linear fog needs end, and start or scale");
  EXPECT_EQ(inFog("fog.color = 1\nfog.end = 1\nfog.start = 0\nfog.scale = 1\n"),
            "x.toml:7: linear fog needs end, and start or scale");
  EXPECT_EQ(inFog("fog.color = 1\nfog.end = 1\nfog.start = 0\nfog.density = 1\n"),
            "x.toml:7: exponential fog, and no other, needs density");
  EXPECT_EQ(inFog("fog.color = 1\nfog.mode = \"exp\"\n"),
            "x.toml:7: exponential fog, and no other, needs density");
  EXPECT_EQ(inFog("fog.color = 1\nfog.mode = \"exp\"\nfog.density = 1\nfog.end = 1\n"),
            "x.toml:7: start, end, scale and extrapolated are for linear fog");
  EXPECT_EQ(mistakeIn("fog = { color = 1, start = 0, end = 1 }"),
            "x.toml:1: family \"f\": fog needs transform.eye_from_object, without transform.viewer");
  EXPECT_EQ(inFog("transform.viewer = \"e\"\nfog = { color = 1, start = 0, end = 1 }\n"),
            "x.toml:1: family \"f\": fog needs transform.eye_from_object, without transform.viewer");
}

TEST(FamilyFileLook, LightKeys) {
  const Family f = parsed(kPaint +
                          "lights.specular_color = [\"s0\", 0.5, [\"s2\", \"t2\"]]\nlights.shininess = "
                          "\"e{}\"\nlights.viewer = \"infinite\"\nlights.clamped = true\n"
                          "lights.enabled = \"on\"\nlights.color = \"l[{}].diffuse.r\"\n");
  ASSERT_EQ(f.lights.specularColor.size(), 3u);
  EXPECT_EQ(f.lights.specularColor[0].uniform, "s0");
  EXPECT_EQ(f.lights.specularColor[1].constant, Numbers{0.5f});
  EXPECT_EQ(f.lights.specularColor[2].uniform, "s2");
  EXPECT_EQ(f.alternatives.at("s2"), std::vector<std::string>{"t2"});
  ASSERT_EQ(f.lights.shininess.size(), 1u);
  EXPECT_EQ(f.lights.shininess[0].uniform, "e{}");
  EXPECT_TRUE(f.lights.infiniteViewer && f.lights.clamped);
  EXPECT_EQ(f.lights.enabled, "on");
  EXPECT_TRUE(f.mentions("e7") && f.mentions("l[3].diffuse") && f.mentions("on"));
  EXPECT_FALSE(f.mentions("l[3].ambient"));
  const Family none = parsed();
  EXPECT_TRUE(none.lights.specularColor.empty() && none.lights.shininess.empty());
  EXPECT_FALSE(none.lights.infiniteViewer || none.lights.clamped);
}

TEST(FamilyFileLook, LightMistakes) {
  EXPECT_EQ(mistakeIn("lights.clamped = true"),
            "x.toml:1: family \"f\": lights.clamped needs vertex.color, without color.diffuse_only");
  EXPECT_EQ(mistakeIn(kPaint + "lights.clamped = true\ncolor.diffuse_only = true"),
            "x.toml:1: family \"f\": lights.clamped needs vertex.color, without color.diffuse_only");
  EXPECT_EQ(mistakeIn("lights.enabled = \"on\""),
            "x.toml:1: family \"f\": lights.enabled needs vertex.color, or lights.unlit_shows = "
            "\"ambient_and_diffuse\"");
  EXPECT_EQ(mistakeIn("lights.count_in_source = \"x\""),
            "x.toml:1: family \"f\": lights.count_in_source needs match.code");
  EXPECT_EQ(mistakeIn("lights.model = \"pbr\"\nlights.viewer = \"infinite\""),
            "x.toml:1: family \"f\": lights.clamped, lights.viewer, lights.half_vector, "
            "lights.highlights_need_shininess and "
            "normals.dark_back_faces are for the model phong");
  EXPECT_EQ(mistakeIn("lights.shininess = []"), "x.toml:6: shininess needs a value");
}

TEST(FamilyFileLook, PbrTexturesAndEnvironments) {
  const Family f = parsed(
      "match.code = \"c\"\nvertex.tangent = \"t\"\ncolor.textures = \"a\"\ncolor.textures_replace_alpha = "
      "true\n"
      "material.unused_opacity_in_source = \"x;\"\n"
      "pbr.roughness = \"r\"\npbr.material_texture = \"m\"\npbr.occlusion_strength = 0.5\n"
      "pbr.emissive_texture = \"e\"\npbr.normal_texture = \"n\"\npbr.normal_scale = \"ns\"\n"
      "pbr.environment_matrix = \"em\"\npbr.irradiance = \"ir\"\n"
      "pbr.irradiance_harmonics = [\"h0\", \"h1\", \"h2\"]\npbr.prefiltered = \"p\"\n"
      "pbr.prefiltered_max_level_in_source = \"max = \"\npbr.brdf_table = \"b\"\n");
  EXPECT_EQ(f.tangent, "t");
  EXPECT_TRUE(f.texturesReplaceAlpha);
  EXPECT_EQ(f.material.unusedOpacityInSource, "x;");
  EXPECT_EQ(f.pbr.occlusionStrength.constant, std::vector<float>{0.5f});
  EXPECT_EQ(f.pbr.normalScale.uniform, "ns");
  EXPECT_EQ(f.pbr.harmonics, (std::vector<std::string>{"h0", "h1", "h2"}));
  EXPECT_EQ(f.pbr.prefilteredMaxLevelInSource, "max = ");
  for (const char* name : {"t", "a", "m", "e", "n", "ns", "em", "ir", "h0", "h1", "h2", "p", "b"})
    EXPECT_TRUE(f.mentions(name)) << name;
}

TEST(FamilyFileLook, PbrMistakes) {
  EXPECT_EQ(mistakeIn("pbr.normal_texture = \"n\""),
            "x.toml:1: family \"f\": pbr.normal_texture needs vertex.tangent");
  EXPECT_EQ(mistakeIn("pbr.prefiltered = \"p\""),
            "x.toml:1: family \"f\": pbr.prefiltered and pbr.brdf_table need each other");
  EXPECT_EQ(
      mistakeIn("pbr.prefiltered_max_level_in_source = \"p\""),
      "x.toml:1: family \"f\": unused_opacity_in_source and prefiltered_max_level_in_source need match.code");
}

TEST(FamilyFileLook, InvisibleBackFaces) {
  EXPECT_EQ(parsed("match.code = \"c\"\nback_material.discards_invisible_in_source = \"discard\"")
                .discardsInvisibleInSource,
            "discard");
  EXPECT_EQ(mistakeIn("back_material.discards_invisible_in_source = \"discard\""),
            "x.toml:1: family \"f\": discards_invisible_in_source needs match.code, and is not for programs "
            "with gl_Vertex");
}

TEST(FamilyFileLook, LightsWithoutHighlights) {
  const Family f = parsed(
      "match.code = \"c\"\nlights.count_in_source = \"lit(\"\nlights.no_highlight_in_source = \"* 0.0\"\n");
  EXPECT_EQ(f.lights.noHighlightInSource, "* 0.0");
  EXPECT_EQ(mistakeIn("lights.no_highlight_in_source = \"0\""),
            "x.toml:1: family \"f\": lights.no_highlight_in_source needs lights.count_in_source");
}

TEST(FamilyFileLook, LightsWithNames) {
  const Family f = parsed(
      "lights.names = [\"key\", \"fill\"]\nlights.color = \"{}_glow\"\nlights.direction = \"l.{}\"\n"
      "lights.shininess = \"{}_shine.r\"\n");
  EXPECT_EQ(f.lights.names, (std::vector<std::string>{"key", "fill"}));
  for (const char* name : {"key_glow", "fill_glow", "l.key", "l.fill", "key_shine"})
    EXPECT_TRUE(f.mentions(name)) << name;
  EXPECT_FALSE(f.mentions("back_glow"));
  EXPECT_EQ(ofLight("{}_glow", f.lights, 1), "fill_glow");
  EXPECT_EQ(ofLight("glow", f.lights, 1), "glow");
  EXPECT_EQ(ofLight("glow[{}]", {}, 12), "glow[12]");
}

TEST(FamilyFileLook, ShiftedInstancesAndConditions) {
  const Family f = parsed("instance.shift_and_scale = \"ss\"\nmatch.resolve_conditions = true\n");
  EXPECT_EQ(f.instanceShift, "ss");
  EXPECT_TRUE(f.mentions("ss") && f.resolvesConditions);
  EXPECT_FALSE(parsed().resolvesConditions);
  EXPECT_EQ(mistakeIn("instance = { shift_and_scale = \"ss\", transform = \"t\" }"),
            "x.toml:6: instances have transform or shift_and_scale, not both");
}

TEST(FamilyFileLook, BackFaces) {
  const Family f = parsed("normals.flip_back_faces = \"both\"\nnormals.dark_back_faces = true\n");
  EXPECT_FALSE(f.flipBackFaces);
  EXPECT_EQ(f.flipsBackFaces, "both");
  EXPECT_TRUE(f.darkBackFaces && f.mentions("both"));
  const Family always = parsed("normals.flip_back_faces = true\n");
  EXPECT_TRUE(always.flipBackFaces);
  EXPECT_EQ(always.flipsBackFaces, "");
  EXPECT_EQ(mistakeIn("normals.flip_back_faces = 1"),
            "x.toml:6: flip_back_faces must be a name in quotes, or a list of such names");
}

TEST(FamilyFileLook, BackFacesWithAColor) {
  const Family f = parsed("color.back_faces = \"inner\"\ncolor.back_faces_if = \"painted\"\n");
  EXPECT_EQ(f.backColor.uniform, "inner");
  EXPECT_EQ(f.backColorIf, "painted");
  EXPECT_TRUE(f.mentions("inner") && f.mentions("painted"));
  EXPECT_EQ(mistakeIn("color.back_faces_if = \"painted\""),
            "x.toml:1: family \"f\": color.back_faces_if needs color.back_faces");
}

TEST(FamilyFileLook, TexturesBeforeLight) {
  const Family f =
      parsed("color.textures = \"t\"\ncolor.textures_if = \"on\"\ncolor.textures_apply = \"before_light\"\n");
  EXPECT_TRUE(f.texturesFirst && f.mentions("on"));
  EXPECT_EQ(f.texturesIf, "on");
  EXPECT_EQ(mistakeIn("color.textures_apply = \"before_light\""),
            "x.toml:1: family \"f\": color.textures_if and color.textures_apply need color.textures");
}

TEST(FamilyFileLook, TexturesOfDiffuseColorsAlone) {
  const Family f = parsed("color.textures = \"t\"\ncolor.textures_apply = \"diffuse\"\n");
  EXPECT_TRUE(f.texturesFirst && f.texturesDiffuseOnly);
}

TEST(FamilyFileLook, PowersOfColors) {
  const Family f = parsed("color.exponent = \"$e\"\ncolor.encoding = 2.2\nlights.model = \"unlit\"\n");
  EXPECT_EQ(f.colorExponent.uniform, "$e");
  EXPECT_TRUE(f.mentions("$e"));
  EXPECT_EQ(f.encoding.constant, Numbers{2.2f});
  EXPECT_EQ(mistakeIn("color.encoding = 2.2"),
            "x.toml:1: family \"f\": color.encoding is for the model unlit");
}

TEST(FamilyFileLook, PbrScatteringAndFloor) {
  const Family f = parsed(
      "pbr.roughness = \"r\"\npbr.environment_intensity = \"i\"\npbr.multiple_scattering = \"$f\"\n"
      "pbr.distribution_floor = 1e-8\n");
  EXPECT_EQ(f.pbr.environmentIntensity.uniform, "i");
  EXPECT_EQ(f.pbr.multipleScattering.uniform, "$f");
  EXPECT_EQ(f.pbr.distributionFloor.constant, Numbers{1e-8f});
}

TEST(FamilyFileLook, RimsOfOpacity) {
  const Family f = parsed("vertex.normal = \"n\"\ncolor.rim.opacity = 2\ncolor.rim.exponent = 5\n");
  EXPECT_TRUE(f.hasRim());
  EXPECT_FALSE(f.rimColor.given());
  EXPECT_EQ(f.rimOpacity.constant, Numbers{2});
  EXPECT_FALSE(parsed().hasRim());
}

TEST(FamilyFileLook, HalfVectorsAndComponentsOfLights) {
  const Family f =
      parsed("lights.color = \"scale.{}\"\nlights.half_vector = \"light{}H\"\ncolor.alpha = false\n");
  EXPECT_EQ(f.lights.halfVector.uniform, "light{}H");
  EXPECT_TRUE(f.mentions("scale") && f.mentions("light3H"));
  EXPECT_EQ(ofLight(f.lights.color, f.lights, 2), "scale.2");
  EXPECT_TRUE(!f.colorAlpha && parsed().colorAlpha);
  EXPECT_EQ(mistakeIn("lights = { model = \"unlit\", half_vector = \"h\" }"),
            "x.toml:1: family \"f\": lights.clamped, lights.viewer, lights.half_vector, "
            "lights.highlights_need_shininess and "
            "normals.dark_back_faces are for the model phong");
}

TEST(FamilyFileLook, ColoursOfHighlightsAndConstantHalfVectors) {
  using HighlightColor = FamilyLights::HighlightColor;
  const std::string color = "vertex.color = \"c\"\n";
  const auto lights = [](const char* which) {
    return std::string("lights.highlight_color = \"") + which + "\"\n";
  };
  EXPECT_EQ(parsed(color + lights("complement")).lights.highlightColor, HighlightColor::complement);
  EXPECT_EQ(parsed(color + lights("base")).lights.highlightColor, HighlightColor::base);
  EXPECT_EQ(parsed().lights.highlightColor, HighlightColor::material);
  EXPECT_EQ(parsed("lights.half_vector = [0, 0.6, 0.8]\n").lights.halfVector.constant,
            (Numbers{0, 0.6f, 0.8f}));
  const std::string mistake =
      "x.toml:1: family \"f\": lights.highlight_color needs vertex.color and the model phong, without "
      "lights.specular_color";
  EXPECT_EQ(mistakeIn(lights("base")), mistake);
  EXPECT_EQ(mistakeIn(color + lights("base") + "lights.model = \"unlit\"\n"), mistake);
  EXPECT_EQ(mistakeIn(color + lights("base") + "lights.specular_color = [1]\n"), mistake);
}

TEST(FamilyFileLook, FogWhoseModeAUniformNames) {
  const Family f =
      parsed(kEye + "fog.color = 1\nfog.mode_from = \"m\"\nfog.end = 1\nfog.scale = 1\nfog.density = 1\n");
  EXPECT_EQ(f.fog.modeFrom, "m");
  EXPECT_TRUE(f.mentions("m"));
  EXPECT_EQ(mistake(kMin + kEye + "fog.color = 1\nfog.mode_from = \"m\"\nfog.end = 1\nfog.scale = 1\n"),
            "x.toml:7: exponential fog, and no other, needs density");
  EXPECT_EQ(mistake(kMin + kEye + "fog.color = 1\nfog.mode_from = \"m\"\nfog.density = 1\n"),
            "x.toml:7: linear fog needs end, and start or scale");
  EXPECT_EQ(
      mistake(kMin + kEye + "fog.color = 1\nfog.end = 1\nfog.scale = 1\nfog.distance = \"absolute_z\"\n"),
      "x.toml:1: family \"f\": fog.distance is for programs with gl_Vertex");
}

TEST(FamilyFileLook, ComponentsOfNames) {
  EXPECT_EQ(componentIn("light.diffuse.r"), 0);
  EXPECT_EQ(componentIn("v.a"), 3);
  EXPECT_EQ(componentIn("v.2"), 2);
  EXPECT_EQ(componentIn("v.4"), -1);
  EXPECT_EQ(componentIn("light.diffuse"), -1);
  EXPECT_EQ(componentIn("v.x"), -1);
  EXPECT_EQ(componentIn(".r"), -1);
  EXPECT_EQ(componentIn("colour"), -1);
}

}  // namespace
}  // namespace gluray::gl

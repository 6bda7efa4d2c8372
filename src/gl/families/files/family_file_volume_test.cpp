// Family files: keys of volumes.
#include "gl/families/family.h"
#include "gl/testing/test_family_text.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace gluray::gl {
namespace {

using scene::VolumeBlend;

/// A family of volumes without the line that begins with `without`, and with more lines.
std::string volumeText(const std::string& more = "", const std::string& without = "") {
  std::string text = "[[code]]\nname = \"c\"\nstatements = \"gl_Position = m * p;\"\n" + kMin;
  for (const char* const line :
       {"match.code = \"c\"\n", "volume.grid = \"g\"\n", "volume.opacity = \"o\"\n", "volume.color = \"k\"\n",
        "volume.texture_from_data = [\"t1\", \"t2\"]\n", "volume.step = \"s\"\n"})
    if (without.empty() || std::string(line).find(without) == std::string::npos) text += line;
  return text + more;
}

Family volumeFamily(const std::string& more = "") {
  const FamilyList list = parseFamilies(volumeText(more), "x.toml");
  EXPECT_EQ(list.size(), 1u);
  return *list.at(0);
}

TEST(FamilyFileVolume, SmallestOneHasDefaults) {
  const Family f = volumeFamily();
  EXPECT_TRUE(f.volume.given());
  EXPECT_EQ(f.volume.grid, "g");
  EXPECT_EQ(f.volume.opacity, "o");
  EXPECT_EQ(f.volume.color, "k");
  EXPECT_EQ(f.volume.textureFromData, (std::vector<std::string>{"t1", "t2"}));
  EXPECT_EQ(f.volume.step.uniform, "s");
  EXPECT_EQ(f.volume.blend, VolumeBlend::composite);
  const FamilyVolume& v = f.volume;
  for (const FamilyValue* const value :
       {&v.scale, &v.bias, &v.depthTexel, &v.depthOrigin, &v.lower, &v.upper, &v.cellStep, &v.cellSpacing,
        &v.range, &v.averaged, &v.colorScale, &v.colorBias, &v.light.materialAmbient,
        &v.light.materialDiffuse, &v.light.materialSpecular, &v.light.shininess, &v.light.diffuse,
        &v.light.specular})
    EXPECT_FALSE(value->given());
  for (const std::string* const name :
       {&v.gradientOpacity, &v.depth, &v.viewer, &v.viewerInWorld, &v.directionInWorld, &v.light.twoSided})
    EXPECT_EQ(*name, "");
  for (const char* const name : {"g", "o", "k", "t1", "t2", "s"}) EXPECT_TRUE(f.mentions(name)) << name;
  EXPECT_FALSE(parsed().volume.given()) << "families have none";
}

TEST(FamilyFileVolume, Blends) {
  for (const auto& [name, blend] :
       {std::pair("composite", VolumeBlend::composite), std::pair("maximum", VolumeBlend::maximum),
        std::pair("minimum", VolumeBlend::minimum), std::pair("average", VolumeBlend::average),
        std::pair("additive", VolumeBlend::additive), std::pair("isosurface", VolumeBlend::isosurface)})
    EXPECT_EQ(volumeFamily("volume.blend = \"" + std::string(name) + "\"\n").volume.blend, blend);
}

TEST(FamilyFileVolume, KeysOfUniforms) {
  const std::vector<std::pair<const char*, FamilyValue FamilyVolume::*>> values = {
      {"scale", &FamilyVolume::scale},
      {"bias", &FamilyVolume::bias},
      {"depth_texel", &FamilyVolume::depthTexel},
      {"depth_origin", &FamilyVolume::depthOrigin},
      {"step", &FamilyVolume::step},
      {"lower", &FamilyVolume::lower},
      {"upper", &FamilyVolume::upper},
      {"cell_step", &FamilyVolume::cellStep},
      {"cell_spacing", &FamilyVolume::cellSpacing},
      {"range", &FamilyVolume::range},
      {"averaged", &FamilyVolume::averaged},
      {"color_scale", &FamilyVolume::colorScale},
      {"color_bias", &FamilyVolume::colorBias},
      {"weights", &FamilyVolume::weights},
      {"gradient_channel", &FamilyVolume::gradientChannel},
      {"contour_count", &FamilyVolume::contourCount},
      {"label_share", &FamilyVolume::labelShare},
      {"label_scale", &FamilyVolume::labelScale},
      {"label_bias", &FamilyVolume::labelBias},
      {"label_count", &FamilyVolume::labelCount}};
  for (const auto& [key, value] : values) {
    const std::string line = "volume." + std::string(key) + " = ";
    const std::string replaced = std::string(key) == "step" ? "step" : "";
    const auto familyWith = [&](const std::string& given) {
      const FamilyList list = parseFamilies(volumeText(line + given, replaced), "x.toml");
      return *list.at(0);
    };
    const Family named = familyWith("\"u\"\n");
    EXPECT_EQ((named.volume.*value).uniform, "u") << key;
    EXPECT_TRUE(named.mentions("u")) << key;
    EXPECT_EQ((familyWith("2.5\n").volume.*value).constant, std::vector<float>{2.5f}) << key;
  }
}

TEST(FamilyFileVolume, KeysOfLight) {
  const std::vector<std::pair<const char*, FamilyValue FamilyVolumeLight::*>> values = {
      {"ambient", &FamilyVolumeLight::materialAmbient},
      {"diffuse", &FamilyVolumeLight::materialDiffuse},
      {"specular", &FamilyVolumeLight::materialSpecular},
      {"shininess", &FamilyVolumeLight::shininess},
      {"light_ambient", &FamilyVolumeLight::ambient},
      {"light_diffuse", &FamilyVolumeLight::diffuse},
      {"light_specular", &FamilyVolumeLight::specular},
      {"light_count", &FamilyVolumeLight::count},
      {"light_positional_count", &FamilyVolumeLight::positional}};
  for (const auto& [key, value] : values) {
    const Family f = volumeFamily("volume." + std::string(key) + " = \"u\"\n");
    EXPECT_EQ((f.volume.light.*value).uniform, "u") << key;
    EXPECT_TRUE(f.mentions("u")) << key;
  }
  const std::vector<std::pair<const char*, std::string FamilyVolumeLight::*>> names = {
      {"two_sided", &FamilyVolumeLight::twoSided},
      {"light_positional", &FamilyVolumeLight::isPositional},
      {"light_direction", &FamilyVolumeLight::direction},
      {"light_position", &FamilyVolumeLight::position},
      {"light_attenuation", &FamilyVolumeLight::attenuation},
      {"light_cone_angle", &FamilyVolumeLight::coneAngle},
      {"light_exponent", &FamilyVolumeLight::exponent}};
  for (const auto& [key, name] : names)
    EXPECT_EQ(volumeFamily("volume." + std::string(key) + " = \"u\"\n").volume.light.*name, "u") << key;
  const Family f =
      volumeFamily("volume.eye_from_texture = [\"a\", \"b\"]\nvolume.eye_from_gradient = \"c\"\n");
  EXPECT_EQ(f.volume.light.eyeFromTexture, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(f.volume.light.eyeFromGradient, std::vector<std::string>{"c"});
}

TEST(FamilyFileVolume, ChannelsAndLighting) {
  using scene::VolumeChannels;
  for (const auto& [name, channels] :
       {std::pair("one", VolumeChannels::one), std::pair("independent", VolumeChannels::independent),
        std::pair("color_and_opacity", VolumeChannels::colorAndOpacity),
        std::pair("colors", VolumeChannels::colors), std::pair("table", VolumeChannels::table),
        std::pair("labels", VolumeChannels::labels)})
    EXPECT_EQ(volumeFamily(
                  "volume.table = \"t\"\nvolume.mask = \"m\"\nvolume.labels = \"l\"\nvolume.channels = \"" +
                  std::string(name) + "\"\n")
                  .volume.channels,
              channels);
  using Model = scene::VolumeShading::Model;
  for (const auto& [name, model] :
       {std::pair("viewer", Model::viewerReflected), std::pair("viewer_halfway", Model::viewerHalfway),
        std::pair("lights", Model::lightsReflected), std::pair("lights_halfway", Model::lightsHalfway)})
    EXPECT_EQ(volumeFamily("volume.lighting = \"" + std::string(name) + "\"\n").volume.light.model, model);
}

TEST(FamilyFileVolume, KeysThatNeedEachOther) {
  const std::string crop = "volume.crop_planes = \"p\"\nvolume.crop_flags = \"f\"\n";
  EXPECT_NE(mistake(volumeText(crop)), "none");
  EXPECT_EQ(mistake(volumeText(crop + "volume.texture_from_crop = \"m\"\n")), "none");
  const std::string slice = "volume.slice_point = \"p\"\nvolume.slice_normal = \"n\"\n";
  EXPECT_NE(mistake(volumeText(slice)), "none");
  const std::string matrices = "volume.data_from_world = \"m\"\nvolume.texture_from_crop = \"m\"\n";
  EXPECT_EQ(mistake(volumeText(slice + matrices)), "none");
  EXPECT_NE(mistake(volumeText(slice + "volume.data_from_world = \"m\"\n")), "none");
  EXPECT_NE(mistake(volumeText("volume.slice_point = \"p\"\n" + matrices)), "none");
  for (const char* const lines : {"volume.channels = \"table\"\n", "volume.channels = \"labels\"\n",
                                  "volume.channels = \"labels\"\nvolume.labels = \"l\"\n"})
    EXPECT_NE(mistake(volumeText(lines)), "none") << lines;
  EXPECT_NE(mistake(volumeText("volume.clip_planes = \"p\"\n")), "none");
}

TEST(FamilyFileVolume, KeysOfNames) {
  const std::vector<std::pair<const char*, std::string FamilyVolume::*>> names = {
      {"gradient_opacity", &FamilyVolume::gradientOpacity},
      {"depth", &FamilyVolume::depth},
      {"viewer", &FamilyVolume::viewer},
      {"viewer_in_world", &FamilyVolume::viewerInWorld},
      {"direction_in_world", &FamilyVolume::directionInWorld},
      {"clip_planes", &FamilyVolume::clipPlanes},
      {"mask", &FamilyVolume::mask},
      {"table", &FamilyVolume::table},
      {"labels", &FamilyVolume::labels},
      {"contours", &FamilyVolume::contours}};
  for (const auto& [key, name] : names) {
    const Family f =
        volumeFamily("volume.data_from_world = [\"w\"]\nvolume." + std::string(key) + " = \"u\"\n");
    EXPECT_EQ(f.volume.*name, "u") << key;
    EXPECT_TRUE(f.mentions("u") && f.mentions("w")) << key;
    EXPECT_EQ(f.volume.dataFromWorld, std::vector<std::string>{"w"});
  }
}

TEST(FamilyFileVolume, NamesMayHaveAlternatives) {
  const Family f = volumeFamily("volume.depth = [\"d\", \"depths\"]\nvolume.scale = [\"a\", \"b\"]\n");
  EXPECT_EQ(f.volume.depth, "d");
  EXPECT_EQ(f.volume.scale.uniform, "a");
  EXPECT_EQ(f.alternatives, (Alternatives{{"d", {"depths"}}, {"a", {"b"}}}));
}

TEST(FamilyFileVolume, HasItsMistakesNamed) {
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos ? std::string() : text;
  };
  EXPECT_EQ(has(mistake(volumeText("", "grid")), "volume needs grid"), "");
  for (const char* const key : {"opacity", "volume.color", "texture_from_data", "step"})
    EXPECT_EQ(has(mistake(volumeText("", key)), "volume needs opacity, color, texture_from_data and step"),
              "")
        << key;
  EXPECT_EQ(has(mistake(volumeText("", "match.code")), "volumes need match.code"), "");
  EXPECT_EQ(has(mistake(volumeText("match.code = \"any\"\n", "match.code")), "volumes need match.code"), "");
  for (const char* const key : {"viewer_in_world", "direction_in_world"})
    EXPECT_EQ(has(mistake(volumeText("volume." + std::string(key) + " = \"u\"\n")),
                  "viewer_in_world and direction_in_world need data_from_world"),
              "");
  EXPECT_EQ(mistake(volumeText("volume.viewer = \"u\"\n")), "none");
  for (const char* const line : {"volume.blend = \"sum\"\n", "volume.grid2 = \"g\"\n", "volume.scale = []\n",
                                 "volume.depth = 3\n", "volume.blend = 1\n", "volume.data_from_world = 1\n"})
    EXPECT_NE(mistake(volumeText(line)), "none") << line;
  EXPECT_NE(mistake(kMin + "volume = 1\n"), "none");
}

TEST(FamilyFileVolume, IsInherited) {
  const FamilyList list =
      parseFamilies(volumeText("volume.scale = 3\nvolume.depth = \"d\"\nvolume.blend = \"additive\"\n"
                               "[[family]]\ninherits = \"f\"\nname = \"more\"\nvolume.blend = \"maximum\"\n"
                               "volume.scale = \"u\"\nvolume.opacity = \"o2\"\n"
                               "[[family]]\ninherits = \"more\"\nname = \"same\"\n"),
                    "x.toml");
  ASSERT_EQ(list.size(), 3u);
  const FamilyVolume &first = list[0]->volume, &more = list[1]->volume, &same = list[2]->volume;
  EXPECT_EQ(first.scale.constant, std::vector<float>{3});
  EXPECT_EQ(first.opacity, "o");
  EXPECT_EQ(first.blend, VolumeBlend::additive);
  EXPECT_EQ(more.scale.uniform, "u");
  EXPECT_EQ(more.opacity, "o2");
  EXPECT_EQ(more.blend, VolumeBlend::maximum);
  for (const FamilyVolume* const v : {&more, &same}) {
    EXPECT_EQ(v->grid, "g");
    EXPECT_EQ(v->depth, "d");
    EXPECT_EQ(v->textureFromData, first.textureFromData);
  }
  EXPECT_EQ(same.blend, VolumeBlend::maximum);
  EXPECT_TRUE(list[2]->mentions("u") && list[2]->mentions("g"));
}

/// A family whose rays end on faces, without the line that begins with `without`, and with more lines.
std::string spanText(const std::string& more = "", const std::string& without = "-") {
  std::string text = "[[family]]\nname = \"n\"\nmatch.active = [\"a\"]\nvertex.position = \"p\"\n";
  for (const std::string line :
       {"match.code = \"c\"\n", "volume.grid = \"g\"\n", "volume.color = \"$map\"\n", "volume.size = \"s\"\n",
        "volume.step = \"t\"\n", "volume.clip_from_data = \"$clip\"\n", "volume.view_from_data = \"$view\"\n",
        "volume.data_from_view = \"$back\"\n"})
    if (!line.starts_with(without)) text += line;
  return text + more;
}

TEST(FamilyFileVolume, RaysThatEndOnFaces) {
  const FamilyList list = parseFamilies(
      spanText("volume.blend = \"over\"\nvolume.depth_shown = \"shown\"\nvolume.shift = \"$half\"\n"
               "volume.limits = \"l\"\nvolume.plane_point = \"q\"\nmatch.whole_main = true\n"),
      "x.toml");
  const Family& family = *list.front();
  EXPECT_TRUE(family.wholeMain);
  const FamilyVolume& v = family.volume;
  EXPECT_TRUE(v.span.given());
  EXPECT_EQ(v.color, "$map");
  EXPECT_EQ(v.span.clip, "$clip");
  EXPECT_EQ(v.span.view, "$view");
  EXPECT_EQ(v.span.viewInverse, "$back");
  EXPECT_EQ(v.span.size.uniform, "s");
  EXPECT_EQ(v.span.shift.uniform, "$half");
  EXPECT_TRUE(v.span.showsDepth);
  EXPECT_EQ(v.blend, VolumeBlend::over);
  EXPECT_EQ(v.levels.limits.uniform, "l");
  EXPECT_EQ(v.levels.planePoint, "q");
  EXPECT_TRUE(family.mentions("$view"));
}

TEST(FamilyFileVolume, RaysThatEndOnFacesNeedTheirKeys) {
  EXPECT_NO_THROW(parseFamilies(spanText(), "x.toml"));
  for (const char* key :
       {"volume.color", "volume.size", "volume.step", "volume.clip_from_data", "volume.data_from_view"})
    EXPECT_THROW(parseFamilies(spanText("", key), "x.toml"), FamilyError) << key;
  EXPECT_THROW(parseFamilies(spanText("volume.color = \"name\"\n", "volume.color"), "x.toml"), FamilyError);
}

}  // namespace
}  // namespace gluray::gl

// Colours, textures, materials, cameras and lights in glTF files: known answers.
#include "saved/testing/test_export.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <png.h>

namespace gluray::saved {
namespace {

using scene::FragmentShading;
using test::exported;
using test::GlbFile;
using test::json;

glm::vec4 baseColor(const GlbFile& file, size_t mesh = 0) {
  const json& c = file.materialOf(mesh).at("pbrMetallicRoughness").at("baseColorFactor");
  return {c[0], c[1], c[2], c[3]};
}

scene::Snapshot square(const test::MeshData& data = test::squareData()) {
  return test::makeSnapshot({test::makeMesh(data)});
}

/// The image of the first texture, RGBA, in the order of the file.
std::vector<uint32_t> pixelsOf(const GlbFile& file, int& width) {
  const json& view = file.gltf["bufferViews"][file.gltf["images"][0]["bufferView"].get<size_t>()];
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const char* bytes = file.binary.data() + view["byteOffset"].get<size_t>();
  EXPECT_TRUE(png_image_begin_read_from_memory(&png, bytes, view["byteLength"].get<size_t>())) << png.message;
  png.format = PNG_FORMAT_RGBA;
  width = static_cast<int>(png.width);
  std::vector<uint32_t> out(size_t{png.width} * png.height);
  EXPECT_TRUE(png_image_finish_read(&png, nullptr, out.data(), 0, nullptr)) << png.message;
  return out;
}

/// A texture of 3 x 2 texels.
scene::Texture smallTexture() {
  auto image = std::make_shared<scene::TextureImage>();
  image->width = 3, image->height = 2;
  image->texels = {0xFF0000FF, 0xFF00FF00, 0xFFFF0000, 0xFF010203, 0xFF808080, 0xFFFFFFFF};
  scene::Texture t;
  t.image = image;
  t.wrapS = scene::Wrap::clampToEdge, t.wrapT = scene::Wrap::mirroredRepeat;
  t.magFilter = scene::Filter::nearest, t.minFilter = scene::Filter::linear,
  t.mipFilter = scene::MipFilter::linear;
  return t;
}

test::MeshData texturedSquare() {
  test::MeshData data = test::squareData();
  data.texcoords = {{0, 0, 0, 1}, {1, 0.25f, 0, 1}, {3, 2, 0, 1}, {-1, 1, 0, 1}};
  return data;
}

TEST(GlbMaterials, ARedQuadIsRed) {
  scene::Snapshot s = square();
  s.instances[0].color = {1, 0, 0, 1};
  const GlbFile file = exported(s);
  EXPECT_EQ(baseColor(file), glm::vec4(1, 0, 0, 1));
  EXPECT_TRUE(file.materialOf(0).at("extensions").contains("KHR_materials_unlit"));
  EXPECT_FALSE(file.primitive(0).at("attributes").contains("COLOR_0"));
  s.instances[0].color = {0.5f, 0.5f, 0.5f, 1};
  EXPECT_NEAR(baseColor(exported(s)).r, 0.21404, 1e-5) << "IEC 61966-2-1: linear light of 0.5";
}

TEST(GlbMaterials, LitSurfacesHaveTheColoursThatTheStateChooses) {
  test::MeshData data = test::squareData();
  data.colors.assign(4, {0, 1, 0, 1});
  scene::Snapshot s = square(data);
  s.shadings[0].lighting = true;
  scene::Material& m = s.instances[0].materials[0].front;
  m.diffuse = {0.2f, 0.4f, 0.6f, 1}, m.specular = {1, 1, 1, 1}, m.shininess = 30, m.emission = {0, 0, 1, 1};
  GlbFile file = exported(s);
  EXPECT_EQ(test::displayed(baseColor(file)), glm::ivec3(51, 102, 153)) << "the diffuse material";
  EXPECT_FALSE(file.primitive(0).at("attributes").contains("COLOR_0"));
  const json& material = file.materialOf(0);
  EXPECT_FALSE(material.contains("extensions"));
  EXPECT_EQ(material.at("emissiveFactor"), json({0, 0, 1}));
  EXPECT_NEAR(material.at("pbrMetallicRoughness").at("roughnessFactor"), 0.5, 1e-6) << "(2 / 32)^(1/4)";
  s.shadings[0].colorMaterial = {scene::ColorMaterial::diffuse, scene::ColorMaterial::diffuse};
  file = exported(s);
  EXPECT_EQ(baseColor(file), glm::vec4(1));
  EXPECT_EQ(glm::vec3(file.attribute(0, "COLOR_0")[2]), glm::vec3(0, 1, 0)) << "glColorMaterial";
}

TEST(GlbMaterials, FlatColoursAreThoseOfLastVertices) {
  test::MeshData data = test::squareData();
  data.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 0, 1}};
  data.normals.assign(4, {0, 0, 1});
  scene::Snapshot s = square(data);
  s.shadings[0].smooth = false;
  const GlbFile file = exported(s);
  const auto colors = file.attribute(0, "COLOR_0");
  ASSERT_EQ(colors.size(), 6u);
  for (size_t i = 0; i < 6; ++i) EXPECT_EQ(colors[i], i < 3 ? glm::vec4(0, 0, 1, 1) : glm::vec4(1, 1, 0, 1));
  EXPECT_FALSE(file.primitive(0).at("attributes").contains("NORMAL"));
}

TEST(GlbMaterials, ProgramsColoursPerTriangle) {
  scene::Snapshot s = square();
  s.shadings[0].fragment.model = FragmentShading::Model::phong;
  s.shadings[0].fragment.color = FragmentShading::Color::perTriangle;
  scene::Instance& instance = s.instances[0];
  instance.triangleColors =
      gluray::test::makeAttribute<uint32_t>({1, 2, 0xFF0000FF, 0xFFFF0000}, scene::Format::unorm8x4);
  instance.triangleOffset = 2;
  instance.materials[0].front.diffuse = {0.1f, 0.1f, 0.1f, 0.25f};
  const GlbFile file = exported(s);
  const auto colors = file.attribute(0, "COLOR_0");
  EXPECT_EQ(colors.at(1), glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(colors.at(4), glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(baseColor(file), glm::vec4(1, 1, 1, 0.25f)) << "the material does not tint them";
}

TEST(GlbMaterials, ATextureIsTheBaseColour) {
  const test::MeshData data = texturedSquare();
  scene::Snapshot s = square(data);
  s.shadings[0].textures = {smallTexture()};
  s.instances[0].color = {1, 1, 0, 1};
  const GlbFile file = exported(s);
  EXPECT_EQ(baseColor(file), glm::vec4(1, 1, 0, 1));
  EXPECT_EQ(file.materialOf(0)["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  const auto at = file.attribute(0, "TEXCOORD_0");
  for (size_t i = 0; i < at.size(); ++i) EXPECT_EQ(glm::vec2(at[i]), glm::vec2(data.texcoords[i]));
  EXPECT_EQ(file.gltf["samplers"][0],
            json({{"magFilter", 9728}, {"minFilter", 9987}, {"wrapS", 33071}, {"wrapT", 33648}}));
  int width = 0;
  EXPECT_EQ(pixelsOf(file, width), smallTexture().image->texels) << "OpenGL's first row is the file's";
  EXPECT_EQ(width, 3);
  s.shadings[0].textures[0].env = scene::TexEnv::replace;
  EXPECT_EQ(baseColor(exported(s)), glm::vec4(1)) << "the texture alone";
}

TEST(GlbMaterials, AMatrixOfCoordinatesMovesThem) {
  scene::Snapshot s = square(texturedSquare());
  scene::Texture t = smallTexture();
  t.textureMatrix = glm::translate(glm::mat4(1), {0.5f, 0, 0}) * glm::scale(glm::mat4(1), {2, 4, 1});
  s.shadings[0].textures = {t};
  EXPECT_EQ(glm::vec2(exported(s).attribute(0, "TEXCOORD_0")[1]), glm::vec2(2.5f, 1));
  t.textureMatrix = glm::mat4(1);
  t.texGen.coordinates[0] = {scene::TexGen::objectLinear, {0.5f, 0, 0, 0.5f}};
  s.shadings[0].textures = {t};
  EXPECT_EQ(glm::vec2(exported(s).attribute(0, "TEXCOORD_0")[1]), glm::vec2(1, 0.25f)) << "generated";
}

TEST(GlbMaterials, TexturesThatTheFormatLacksColourVertices) {
  scene::Snapshot s = square(texturedSquare());
  scene::Texture t = smallTexture();
  t.env = scene::TexEnv::add;
  s.shadings[0].textures = {t};
  s.instances[0].color = {0, 0, 1, 1};
  std::vector<std::string> notes;
  const GlbFile file = exported(s, &notes);
  EXPECT_FALSE(file.gltf.contains("images"));
  EXPECT_EQ(glm::vec3(file.attribute(0, "COLOR_0")[0]), glm::vec3(1, 0, 1)) << "blue and the red texel";
  EXPECT_EQ(notes.size(), 1u);
}

TEST(GlbMaterials, CombinedTexturesThatAreFactorsStay) {
  scene::Snapshot s = square(texturedSquare());
  scene::Texture t = smallTexture();
  t.env = scene::TexEnv::combine;
  using Combine = scene::Combine;
  t.combine.rgb.arguments[1].source = Combine::primary;
  t.combine.alphaPart.function = Combine::replace;
  t.combine.alphaPart.arguments[0] = {Combine::previous, Combine::alpha};
  s.shadings[0].textures = {t};
  s.instances[0].color = {0, 1, 1, 1};
  GlbFile file = exported(s);
  EXPECT_EQ(baseColor(file), glm::vec4(0, 1, 1, 1));
  EXPECT_TRUE(file.gltf.contains("images")) << "a product";
  t.combine.rgb.function = Combine::addSigned;
  s.shadings[0].textures = {t};
  EXPECT_FALSE(exported(s).gltf.contains("images"));
}

TEST(GlbMaterials, OfSeveralFactorsTheLargestTextureStays) {
  scene::Snapshot s = square(texturedSquare());
  auto image = std::make_shared<scene::TextureImage>();
  image->width = image->height = 1, image->texels = {0xFF0000FF};
  scene::Texture red = smallTexture();
  red.image = image, red.unit = 1;
  s.shadings[0].textures = {red, smallTexture()};
  s.shadings[0].textures[0].unit = 0, s.shadings[0].textures[1].unit = 1;
  s.instances[0].texcoordsAbove = {{0.5f, 0.5f, 0, 1}};
  std::vector<std::string> notes;
  const GlbFile file = exported(s, &notes);
  int width = 0;
  EXPECT_EQ(pixelsOf(file, width).size(), 6u);
  EXPECT_EQ(glm::vec3(file.attribute(0, "COLOR_0")[3]), glm::vec3(1, 0, 0)) << "the other one's colour";
  EXPECT_EQ(glm::vec2(file.attribute(0, "TEXCOORD_0")[3]), glm::vec2(0.5f)) << "the coordinates of its unit";
  EXPECT_EQ(notes.size(), 1u);
}

TEST(GlbMaterials, AColourMapIsATexture) {
  scene::Snapshot s = square(texturedSquare());
  FragmentShading& f = s.shadings[0].fragment;
  f.model = FragmentShading::Model::phong, f.color = FragmentShading::Color::map;
  f.map = {smallTexture()};
  const GlbFile file = exported(s);
  EXPECT_EQ(file.gltf["samplers"][0]["wrapT"], 33071) << "programs' maps end at their edges";
  EXPECT_EQ(file.gltf["samplers"][0]["minFilter"], 9728) << "and have one level";
  EXPECT_EQ(baseColor(file), glm::vec4(1));
}

TEST(GlbMaterials, PhysicallyBasedOnesKeepTheirValues) {
  test::MeshData data = texturedSquare();
  data.normals.assign(4, {0, 0, 1});
  scene::Snapshot s = square(data);
  FragmentShading& f = s.shadings[0].fragment;
  f.model = FragmentShading::Model::pbr;
  f.pbr.metallic = 0.75f, f.pbr.roughness = 0.25f, f.pbr.emissive = {0, 1, 0}, f.pbr.normalScale = 0.5f;
  f.pbr.textures = {smallTexture(), smallTexture()};
  f.pbr.material = 0, f.pbr.normal = 1;
  const GlbFile file = exported(s);
  const json& m = file.materialOf(0);
  EXPECT_EQ(m["pbrMetallicRoughness"]["metallicFactor"], 0.75f);
  EXPECT_EQ(m["pbrMetallicRoughness"]["roughnessFactor"], 0.25f);
  EXPECT_EQ(m["emissiveFactor"], json({0, 1, 0}));
  EXPECT_EQ(m["normalTexture"]["scale"], 0.5f);
  EXPECT_TRUE(m["pbrMetallicRoughness"].contains("metallicRoughnessTexture"));
  EXPECT_EQ(file.gltf["images"].size(), 2u) << "two images in memory";
}

TEST(GlbMaterials, LayersBlendAndAlphaTestsMask) {
  scene::Snapshot s = square();
  s.instances[0].color = {1, 1, 1, 0.5f};
  EXPECT_FALSE(exported(s).materialOf(0).contains("alphaMode"));
  s.shadings[0].alphaTest = {scene::AlphaTest::greaterOrEqual, false, 0.25f};
  EXPECT_EQ(exported(s).materialOf(0).at("alphaCutoff"), 0.25f);
  s.shadings[0].alphaTest = {};
  s.layers = std::make_shared<scene::Layers>();
  const GlbFile file = exported(s);
  EXPECT_EQ(file.materialOf(0).at("alphaMode"), "BLEND");
  EXPECT_EQ(baseColor(file).a, 0.5f);
}

TEST(GlbMaterials, CamerasAreThoseOfTheView) {
  scene::Snapshot s = square();
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.5, 0.1, 100.0);
  s.eyeFromWorld = glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), glm::dvec3(0, 1, 0));
  s.instances[0].eyeFromObject = s.eyeFromWorld;
  GlbFile file = exported(s);
  const json perspective = file.gltf["cameras"][0]["perspective"];
  EXPECT_NEAR(perspective["yfov"], glm::radians(40.0), 1e-9);
  EXPECT_NEAR(perspective["aspectRatio"], 1.5, 1e-9);
  EXPECT_NEAR(perspective["znear"], 0.1, 1e-9);
  EXPECT_NEAR(perspective["zfar"], 100, 1e-6);
  EXPECT_LT(glm::length(glm::dvec3(file.matrixOf(1)[3]) - glm::dvec3(0, 0, 5)), 1e-9);
  s.camera.clipFromEye = glm::ortho(-3.0, 3.0, -2.0, 2.0, 1.0, 10.0);
  file = exported(s);
  const json parallel = file.gltf["cameras"][0]["orthographic"];
  EXPECT_NEAR(parallel["xmag"], 3, 1e-9);
  EXPECT_NEAR(parallel["ymag"], 2, 1e-9);
  EXPECT_NEAR(parallel["zfar"].get<double>() - parallel["znear"].get<double>(), 9, 1e-6);
}

TEST(GlbMaterials, LightsAreAsBrightAsThePrograms) {
  scene::Snapshot s = square();
  s.shadings[0].lighting = true;
  scene::Light sun, lamp;
  sun.diffuse = {1, 1, 1, 1}, sun.position = {0, 0, 1, 0};
  lamp.diffuse = {0.5f, 0, 0, 1}, lamp.position = {0, 0, 2, 1}, lamp.spotCutoff = 30;
  s.shadings[0].lights = {sun, lamp};
  const GlbFile file = exported(s);
  const json lights = file.gltf["extensions"]["KHR_lights_punctual"]["lights"];
  EXPECT_EQ(lights[0]["type"], "directional");
  EXPECT_NEAR(lights[0]["intensity"], glm::pi<double>(), 1e-6) << "a white surface that faces it is white";
  EXPECT_EQ(lights[1]["type"], "spot");
  EXPECT_NEAR(lights[1]["intensity"], glm::pi<double>() * scene::decodedSrgb(0.5f) * 4, 1e-5);
  EXPECT_EQ(lights[1]["color"], json({1, 0, 0}));
  EXPECT_NEAR(lights[1]["spot"]["outerConeAngle"], glm::radians(30.0), 1e-6);
  lamp.spotCutoff = 180, lamp.position = {3, 0, 4, 1}, lamp.attenuation = {0.5f, 0, 0};
  s.shadings[0].lights = {lamp};
  const GlbFile far = exported(s);
  const json light = far.gltf["extensions"]["KHR_lights_punctual"]["lights"][0];
  EXPECT_EQ(light["type"], "directional") << "far away, without fading";
  EXPECT_NEAR(light["intensity"], glm::pi<double>(), 1e-5) << "twice its half";
  const glm::dvec3 back(far.matrixOf(1)[2]);
  EXPECT_LT(glm::length(back - glm::dvec3(0.6, 0, 0.8)), 1e-6);
}

}  // namespace
}  // namespace gluray::saved

#include "cluster/stream/snapshot_decoder.h"
#include "cluster/stream/snapshot_encoder.h"
#include "scene/backdrop.h"
#include "scene/secondary_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <random>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gluray::cluster {
namespace {

template <class T>
scene::Attribute attributeOf(std::vector<T> values, scene::Format format, uint32_t stride = sizeof(T)) {
  auto owner = std::make_shared<const std::vector<T>>(std::move(values));
  return {owner, reinterpret_cast<const std::byte*>(owner->data()), stride, format};
}

/// Two triangles of four vertices, positions and normals side by side.
scene::MeshPtr twoTriangles() {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->triangleCount = 2, mesh->vertexCount = 4;
  std::vector<std::array<glm::vec3, 2>> vertices(4);
  for (size_t i = 0; i < 4; ++i)
    vertices[i] = {glm::vec3(i & 1, i >> 1, 0), glm::vec3(0, 0.1f * static_cast<float>(i), 1)};
  mesh->positions = attributeOf(vertices, scene::Format::float3);
  mesh->normals = mesh->positions;
  mesh->normals.data += sizeof(glm::vec3);
  mesh->indices = attributeOf<uint32_t>({0, 1, 2, 2, 1, 3}, scene::Format::uint32);
  mesh->colors =
      attributeOf<uint32_t>({0xff0000ff, 0xff00ff00, 0xffff0000, 0x80ffffff}, scene::Format::unorm8x4);
  mesh->materials = attributeOf<uint32_t>({0, 0, 1, 1}, scene::Format::uint32);
  mesh->texcoordsAbove = {
      {}, attributeOf<glm::vec2>(std::vector<glm::vec2>(4, {0.5f, 1}), scene::Format::float2)};
  mesh->upper = {1, 1, 0};
  mesh->opaqueColors = false;
  mesh->geometryId = hashBytes("two", 3);
  return mesh;
}

std::shared_ptr<const scene::TextureImage> image() {
  auto image = std::make_shared<scene::TextureImage>();
  image->width = 2, image->height = 2, image->texels = {1, 2, 3, 0xff000004};
  image->opaque = false;
  image->mipmaps.resize(1);
  image->mipmaps[0].width = image->mipmaps[0].height = 1;
  image->mipmaps[0].floats = {{0.25f, 1, 2, 3}};
  return image;
}

scene::Shading shading() {
  scene::Shading s;
  s.lighting = s.twoSided = true;
  s.lights.resize(2);
  s.lights[1].spotCutoff = 30;
  s.textures.resize(2);
  s.textures[0].image = s.textures[1].image = image();
  s.textures[1].unit = 2, s.textures[1].combine.rgb.arguments[1].source = scene::Combine::constant;
  s.textures[1].texGen.coordinates[2] = {scene::TexGen::eyeLinear, {1, 2, 3, 4}};
  s.fog.mode = scene::Fog::exp2;
  s.fog.scaled = s.fog.extrapolates = true, s.fog.scale = 0.5f;
  s.fragment.lights.resize(1);
  s.fragment.lights[0].ownHighlight = s.fragment.clampsLight = s.fragment.darkBackFaces = true;
  s.fragment.lights[0].highlight = {1, 2, 3}, s.fragment.lights[0].shininess = 4;
  s.fragment.lights[0].half = {0.5f, 0.25f, 2};
  s.fragment.rim = {true, false, {1, 2, 3}, 4, 5};
  s.fragment.texturesFirst = s.fragment.ignoresAlpha = s.fragment.texturesKeepAlpha = true;
  s.fragment.colorExponent = 2.2f, s.fragment.encoding = 1.8f;
  s.fragment.paintsBack = true, s.fragment.backColor = {0.5f, 0.25f, 1};
  s.fragment.edgeColor = {1, 0, 0.5f};
  s.textures[0].maxAnisotropy = 4, s.textures[0].byteFilter = true;
  scene::PbrSurface& pbr = s.fragment.pbr;
  pbr.textures = {s.textures[0]}, pbr.material = 0, pbr.occlusionStrength = 0.5f, pbr.normalScale = 2;
  pbr.masking = scene::PbrSurface::Masking::separate, pbr.ambient = {0.5f, 2, 1};
  s.fragment.matcap.assign(4, s.textures[1]), s.fragment.backFactor = 0.7f;
  s.fragment.facesViewer = s.fragment.flipsTriangles = true;
  s.fragment.unitNormals = scene::FragmentShading::UnitNormals::never;
  pbr.environment.brdf = {s.textures[0]};
  pbr.environment.harmonics[2][8] = 3, pbr.environment.byHarmonics = true, pbr.environment.maxLevel = 4;
  pbr.environment.worldFromEye[1].z = 0.5f;
  pbr.environment.intensity = 0.7f, pbr.environment.diffuseF0 = 0.04f, pbr.distributionFloor = 1e-8f;
  return s;
}

scene::Instance instanceOf(scene::MeshPtr mesh) {
  scene::Instance i;
  i.mesh = std::move(mesh);
  i.eyeFromObject = glm::translate(glm::dmat4(1), {1, 2, -3});
  i.object.value = 7;
  i.texcoordsAbove = {{1, 2, 3, 4}};
  i.materials.resize(2);
  i.materials[1].back.shininess = 12;
  i.triangleColors = attributeOf<glm::vec4>(std::vector<glm::vec4>(5, {0, 1, 2, 3}), scene::Format::float4);
  i.triangleEdges = attributeOf<uint8_t>({1, 2, 3, 4, 5, 6}, scene::Format::bits8);
  i.triangleOffset = 3;
  i.impostors.centerPlanes = {{0, 0, 1, 2}};
  i.clipPlanes = {{1, 0, 0, 0.5}};
  i.cull = scene::CullFace::back;
  return i;
}

scene::Snapshot snapshot() {
  scene::Snapshot s;
  s.frame = 12, s.view = 3;
  s.region = {1, 2, 3, 2};
  s.camera.viewport = {0, 0, 640, 480};
  s.camera.clipFromEye = glm::perspective(1.0, 1.5, 0.1, 10.0);
  s.samplePositions = {{0.5f, 0.5f}};
  s.lightSampling = {scene::LightSampling::Mode::moving, 4,
                     std::make_shared<const std::vector<uint8_t>>(1, uint8_t{1})};
  auto layers = std::make_shared<scene::Layers>();
  layers->of = scene::Layers::Of::drawn;
  layers->opaqueDepth.assign(6, 0.5f), layers->colors.assign(6, 0xff102030);
  layers->floatColors.assign(6, {2, -1, 0.5f, 1}), layers->halfFloats = true;
  layers->blending.rgb = {scene::BlendEquation::subtract, scene::BlendFactor::constantAlpha,
                          scene::BlendFactor::one};
  s.layers = layers;
  s.shadings = {shading(), {}};
  const scene::MeshPtr mesh = twoTriangles();
  s.instances = {instanceOf(mesh), instanceOf(twoTriangles()), instanceOf(mesh)};
  s.instances[2].shading = 1;
  auto around = std::make_shared<scene::SecondaryScene>();
  around->shadings = {shading()};
  around->instances = {instanceOf(mesh)};
  around->blended = {1};
  auto capture = std::make_shared<scene::FramebufferCapture>();
  capture->region = {1, 2, 2, 1}, capture->depthFar = 0.5f, capture->offset.units = 3;
  capture->colors = {1, 2}, capture->depths = {0.25f, scene::FramebufferCapture::kNothing};
  capture->content = {5, 6};
  around->captures = {capture};
  around->captured = {{0, glm::dmat4(2)}};
  s.secondaryScene = around;
  s.backdrop = std::make_shared<const scene::Backdrop>(scene::Backdrop{std::vector<uint8_t>(6, 1)});
  s.settings.ao.enabled = true;
  s.settings.ao.samples = 9;
  s.settings.material.objects = {"3 glass ior=1.4"};
  s.settings.quirks.set("fog-sum", false);
  return s;
}

class Ends {
 public:
  scene::SnapshotPtr sent(const scene::Snapshot& s) {
    last = encoder_.encode(s);
    for (const ArraySource& array : last.arrays) arrays.try_emplace(array.name, makeArray(array));
    return decoder_.decode(last.message);
  }
  scene::SnapshotPtr read(const std::vector<std::byte>& message) { return decoder_.decode(message); }
  EncodedSnapshot last;
  std::unordered_map<Hash128, Array> arrays;

 private:
  SnapshotEncoder encoder_;
  SnapshotDecoder decoder_{[this](const Hash128& name) {
    const auto known = arrays.find(name);
    return known == arrays.end() ? Array{} : known->second;
  }};
};

TEST(SnapshotStream, WhatIsReadWritesTheSameMessage) {
  Ends ends;
  const scene::SnapshotPtr once = ends.sent(snapshot());  // has each mesh once
  const scene::SnapshotPtr read = ends.sent(*once);
  const EncodedSnapshot first = ends.last;
  ends.sent(*read);
  EXPECT_EQ(first.message, ends.last.message);
  ASSERT_EQ(first.arrays.size(), ends.last.arrays.size());
  for (size_t i = 0; i < first.arrays.size(); ++i) EXPECT_EQ(first.arrays[i].name, ends.last.arrays[i].name);
}

TEST(SnapshotStream, ValuesArrive) {
  Ends ends;
  const scene::Snapshot s = snapshot();
  const scene::SnapshotPtr read = ends.sent(s);
  EXPECT_EQ(read->frame, 12u);
  EXPECT_EQ(read->camera, s.camera);
  EXPECT_EQ(read->settings, s.settings);
  EXPECT_EQ(*read->layers, *s.layers);
  EXPECT_EQ(*read->backdrop, *s.backdrop);
  EXPECT_EQ(read->shadings[0].lights, s.shadings[0].lights);
  scene::PbrSurface pbr = read->shadings[0].fragment.pbr;
  EXPECT_EQ(pbr.textures[0].image->texels, s.shadings[0].textures[0].image->texels);
  pbr.textures[0].image = pbr.environment.brdf[0].image = s.shadings[0].textures[0].image;
  EXPECT_EQ(pbr, s.shadings[0].fragment.pbr);
  EXPECT_EQ(read->shadings[0].textures[0].image->texels, s.shadings[0].textures[0].image->texels);
  const scene::Instance &got = read->instances[1], &wanted = s.instances[1];
  EXPECT_EQ(got.object.value, 7u);
  EXPECT_EQ(got.materials, wanted.materials);
  EXPECT_EQ(got.mesh->position(3), wanted.mesh->position(3));
  EXPECT_EQ(scene::fetch(got.mesh->normals, 2), scene::fetch(wanted.mesh->normals, 2));
  EXPECT_EQ(got.mesh->corner(1, 2), 3u);
  EXPECT_EQ(scene::fetch(got.triangleColors, got.triangleOffset + 1), scene::fetch(wanted.triangleColors, 4));
  EXPECT_EQ(got.triangleEdges.data[got.triangleOffset + 1], std::byte{5});
  EXPECT_EQ(read->secondaryScene->blended, s.secondaryScene->blended);
  EXPECT_TRUE(scene::haveSameCaptures(*read->secondaryScene, *s.secondaryScene));
  const scene::FramebufferCapture &seen = *read->secondaryScene->captures[0],
                                  &sent = *s.secondaryScene->captures[0];
  EXPECT_EQ(seen.region, sent.region);
  EXPECT_EQ(seen.offset, sent.offset);
  EXPECT_EQ(seen.depthFar, sent.depthFar);
  EXPECT_EQ(seen.colors, sent.colors);
  EXPECT_EQ(seen.depths, sent.depths);
}

TEST(SnapshotStream, SticksArrive) {
  Ends ends;
  scene::Snapshot s = snapshot();
  auto mesh = std::make_shared<scene::Mesh>(*twoTriangles());
  mesh->shape = scene::Shape::sticks;
  mesh->indices = {};
  mesh->ends = attributeOf<uint32_t>({1, 2, 3, 7}, scene::Format::uint32);
  s.instances[1].mesh = mesh;
  s.instances[1].impostors.inPixels = true, s.instances[1].impostors.longer = 2;
  s.instances[1].impostors.roundEnds = false, s.instances[1].impostors.halvesBlend = 0.5f;
  const scene::SnapshotPtr read = ends.sent(s);
  const scene::Instance& got = read->instances[1];
  EXPECT_EQ(got.mesh->shape, scene::Shape::sticks);
  EXPECT_EQ(got.mesh->endAt(3), 7u);
  EXPECT_EQ(got.impostors, s.instances[1].impostors);
  EXPECT_EQ(read->instances[0].mesh->endAt(0), 0u);
}

TEST(SnapshotStream, EqualContentIsSentAndKeptOnce) {
  Ends ends;
  const scene::Snapshot s = snapshot();
  const scene::SnapshotPtr first = ends.sent(s);
  const size_t arrays = ends.arrays.size();
  EXPECT_EQ(first->instances[0].mesh, first->instances[1].mesh);  // two meshes of equal content
  EXPECT_EQ(first->instances[0].mesh, first->secondaryScene->instances[0].mesh);
  EXPECT_EQ(first->shadings[0].textures[0].image, first->secondaryScene->shadings[0].textures[1].image);
  const scene::SnapshotPtr second = ends.sent(snapshot());
  EXPECT_EQ(ends.arrays.size(), arrays);
  EXPECT_EQ(first->instances[0].mesh, second->instances[0].mesh);
  EXPECT_EQ(first->shadings[0].textures[0].image, second->shadings[0].textures[0].image);
}

TEST(SnapshotStream, MessagesWithoutTheirArraysAreRefused) {
  Ends ends;
  ends.sent(snapshot());
  for (const ArraySource& array : ends.last.arrays) {
    const auto kept = ends.arrays.extract(array.name);
    EXPECT_THROW(ends.read(ends.last.message), Malformed);
    ends.arrays[array.name] = makeArray(std::vector<std::byte>(array.bytes() + 4));
    EXPECT_THROW(ends.read(ends.last.message), Malformed);
    ends.arrays[array.name] = kept.mapped();
  }
}

TEST(SnapshotStream, ShortMessagesAreRefused) {
  Ends ends;
  ends.sent(snapshot());
  for (size_t length = 0; length < ends.last.message.size(); ++length)
    EXPECT_THROW(ends.read({ends.last.message.begin(),
                            ends.last.message.begin() + static_cast<std::ptrdiff_t>(length)}),
                 Malformed);
  std::vector<std::byte> longer = ends.last.message;
  longer.push_back({});
  EXPECT_THROW(ends.read(longer), Malformed);
}

TEST(SnapshotStream, ChangedMessagesAreRefusedOrSane) {
  Ends ends;
  ends.sent(snapshot());
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::vector<std::byte> message = ends.last.message;
    for (auto left = 1 + random() % 3; left > 0; --left)
      message[random() % message.size()] = static_cast<std::byte>(random() % 5 == 0 ? 0xff : random());
    try {
      const scene::SnapshotPtr read = ends.read(message);
      for (const scene::Instance& instance : read->instances)
        ASSERT_LT(instance.shading, read->shadings.size());
    } catch (const Malformed&) { ++refused; }
  }
  EXPECT_GT(refused, 1000);
}

TEST(SnapshotStream, TrianglesOfVerticesThatDoNotExistAreRefused) {
  Ends ends;
  scene::Snapshot s = snapshot();
  auto mesh = std::make_shared<scene::Mesh>(*twoTriangles());
  mesh->indices = attributeOf<uint32_t>({0, 1, 2, 2, 1, 4}, scene::Format::uint32);
  s.instances[1].mesh = mesh;
  EXPECT_THROW(ends.sent(s), Malformed);
  mesh = std::make_shared<scene::Mesh>(*twoTriangles());
  mesh->materials = attributeOf<uint32_t>({0, 0, 1, 2}, scene::Format::uint32);
  s.instances[1].mesh = mesh;
  EXPECT_THROW(ends.sent(s), Malformed);
}

}  // namespace
}  // namespace gluray::cluster

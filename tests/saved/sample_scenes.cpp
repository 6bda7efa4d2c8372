#include "tests/saved/sample_scenes.h"

#include "accel/testing/test_scene.h"
#include "frame/testing/mixed_scenes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace gluray::test {
namespace {

constexpr int kSize = 256;

void look(scene::Snapshot& s, const glm::dvec3& from, const glm::dvec3& at) {
  s.camera.clipFromEye = glm::perspective(glm::radians(35.0), 1.0, 0.5, 50.0);
  s.eyeFromWorld = glm::lookAt(from, at, glm::dvec3(0, 1, 0));
  for (scene::Instance& instance : s.instances)
    instance.eyeFromObject = s.eyeFromWorld * instance.eyeFromObject;
  s.settings.look = Look::honest;
}

SampleScene sample(const char* name, scene::Snapshot s) {
  for (size_t i = 0; i < s.instances.size(); ++i) {
    s.instances[i].order = static_cast<uint32_t>(i);
    s.instances[i].worldFromObject = glm::mat4(glm::inverse(s.eyeFromWorld) * s.instances[i].eyeFromObject);
  }
  return {name, std::make_shared<const scene::Snapshot>(std::move(s))};
}

/// Instances of one coloured patch, turned, scaled and mirrored.
scene::Snapshot patches() {
  MeshData data;
  constexpr int kCells = 12;
  for (int j = 0; j <= kCells; ++j)
    for (int i = 0; i <= kCells; ++i) {
      const float x = static_cast<float>(i) / kCells, y = static_cast<float>(j) / kCells;
      data.positions.emplace_back(2 * x - 1, 2 * y - 1, 0.3f * std::sin(4 * x) * y);
      data.colors.emplace_back(x, y, 0.5f, 1);
    }
  for (uint32_t j = 0; j < kCells; ++j)
    for (uint32_t i = 0; i < kCells; ++i) {
      const uint32_t a = j * (kCells + 1) + i, b = a + 1, c = b + kCells + 1, d = c - 1;
      data.indices.insert(data.indices.end(), {a, b, c, a, c, d});
    }
  scene::Snapshot s = makeSnapshot({makeMesh(data)}, kSize);
  for (int i = 0; i < 3; ++i) s.instances.push_back(s.instances[0]);
  s.instances[1].eyeFromObject = glm::translate(glm::dmat4(1), {2.2, 0, 0});
  s.instances[2].eyeFromObject =
      glm::translate(glm::dmat4(1), {0, 2.2, 0}) * glm::rotate(glm::dmat4(1), 0.7, {1, 1, 0});
  s.instances[3].eyeFromObject =
      glm::translate(glm::dmat4(1), {2.2, 2.2, 0}) * glm::scale(glm::dmat4(1), {-0.8, 0.6, 1.5});
  look(s, {1.1, 1.1, 8}, {1.1, 1.1, 0});
  return s;
}

/// A square with a texture of 4 x 4 squares, each of a colour.
scene::Snapshot textured() {
  MeshData data = squareData();
  data.texcoords = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}};
  scene::Snapshot s = makeSnapshot({makeMesh(data)}, kSize);
  auto image = std::make_shared<scene::TextureImage>();
  image->width = image->height = 4;
  for (uint32_t i = 0; i < 16; ++i)
    image->texels.push_back(0xFF000000 | i * 16 << 16 | (i % 4) * 80 << 8 | (i / 4) * 60);
  scene::Texture t;
  t.image = image;
  t.wrapS = t.wrapT = scene::Wrap::clampToEdge;
  t.magFilter = t.minFilter = scene::Filter::nearest;
  t.env = scene::TexEnv::replace;
  s.shadings[0].textures = {t};
  look(s, {0.5, 0.3, 4}, {0, 0, 0});
  return s;
}

/// Balls and sticks, as molecules are drawn.
scene::Snapshot molecule() {
  MeshData balls, bonds;
  std::vector<float> radii;
  for (int i = 0; i < 8; ++i) {
    const float t = static_cast<float>(i);
    balls.positions.emplace_back(std::cos(t), 0.4f * t - 1.4f, std::sin(t));
    balls.colors.emplace_back(i % 2, 0.25f * static_cast<float>(i % 5), 1 - i % 2, 1);
    radii.push_back(0.25f + 0.02f * t);
  }
  for (uint32_t i = 0; i < 7; ++i) bonds.indices.insert(bonds.indices.end(), {i, i + 1});
  bonds.positions = balls.positions, bonds.colors = balls.colors;
  auto spheres = std::const_pointer_cast<scene::Mesh>(makeMesh(balls));
  auto sticks = std::const_pointer_cast<scene::Mesh>(makeMesh(bonds));
  spheres->shape = scene::Shape::spheres, spheres->triangleCount = 8;
  spheres->radii = makeAttribute(radii, scene::Format::float1);
  sticks->shape = scene::Shape::sticks, sticks->triangleCount = 7, sticks->radius = 0.1f;
  sticks->ends = makeAttribute<uint32_t>(std::vector<uint32_t>(8, scene::kTwoHalves), scene::Format::uint32);
  scene::Snapshot s = makeSnapshot({spheres, sticks}, kSize);
  s.shadings[0].fragment.model = scene::FragmentShading::Model::phong;
  s.shadings[0].fragment.color = scene::FragmentShading::Color::vertices;
  look(s, {0, 1, 8}, {0, 0, 0});
  for (scene::Instance& instance : s.instances) {
    instance.lightingFromObject = glm::mat4(instance.eyeFromObject);
    instance.materials[0].front.diffuse = {1, 1, 1, 1};
  }
  return s;
}

/// Balls that lights light, of several batches' state.
scene::Snapshot lit() {
  scene::Snapshot s = frame::test::balls(kSize, frame::test::Floor::none);
  s.settings.ao.enabled = false;
  s.settings.look = Look::honest;
  s.shadings[0].lighting = true;
  s.shadings[0].colorMaterial = {scene::ColorMaterial::diffuse, scene::ColorMaterial::diffuse};
  s.shadings[0].lights.resize(2);
  s.shadings[0].lights[1].position = {1, 2, 3, 1};
  return s;
}

/// A surface with a colour map, which its program looks up.
scene::Snapshot mapped() {
  scene::Snapshot s = patches();
  s.instances.resize(1);
  auto mesh = std::make_shared<scene::Mesh>(*s.instances[0].mesh);
  std::vector<glm::vec2> at;
  for (uint32_t v = 0; v < mesh->vertexCount; ++v) at.emplace_back(0.5f + 0.5f * mesh->position(v).x, 0.5f);
  mesh->colors = {}, mesh->texcoords = makeAttribute(at, scene::Format::float2);
  s.instances[0].mesh = mesh;
  scene::FragmentShading& f = s.shadings[0].fragment;
  f.model = scene::FragmentShading::Model::phong, f.color = scene::FragmentShading::Color::map;
  auto image = std::make_shared<scene::TextureImage>();
  image->width = 8, image->height = 1;
  for (uint32_t i = 0; i < 8; ++i) image->texels.push_back(0xFF000000 | (255 - i * 36) << 16 | i * 36);
  scene::Texture t;
  t.image = image;
  t.magFilter = t.minFilter = scene::Filter::nearest;
  f.map = {t};
  s.camera.clipFromEye = glm::ortho(-1.5, 1.5, -1.5, 1.5, 0.5, 50.0);
  s.camera.clipFromEye = glm::translate(glm::dmat4(1), {0.4, 0.4, 0}) * s.camera.clipFromEye;
  return s;
}

}  // namespace

std::vector<SampleScene> sampleScenes() {
  return {sample("patches", patches()), sample("textured", textured()), sample("molecule", molecule()),
          sample("lit", lit()), sample("mapped", mapped())};
}

scene::SnapshotPtr largeScene(uint32_t triangles) {
  const auto cells = static_cast<uint32_t>(std::sqrt(triangles / 2));
  const uint32_t rows = triangles / 2 / cells;
  MeshData data;
  std::vector<uint32_t> colors;
  for (uint32_t j = 0; j <= rows; ++j)
    for (uint32_t i = 0; i <= cells; ++i) {
      const float x = static_cast<float>(i), y = static_cast<float>(j);
      data.positions.emplace_back(x, y, std::sin(0.01f * x) * std::sin(0.01f * y));
      data.normals.emplace_back(0.1f, 0.2f, 0.97f);
      colors.push_back(0xFF000000 | i * 2654435761u >> 8);
    }
  for (uint32_t j = 0; j < rows; ++j)
    for (uint32_t i = 0; i < cells; ++i) {
      const uint32_t a = j * (cells + 1) + i, b = a + 1, c = b + cells + 1, d = c - 1;
      data.indices.insert(data.indices.end(), {a, b, c, a, c, d});
    }
  auto mesh = std::const_pointer_cast<scene::Mesh>(makeMesh(data));
  mesh->colors = makeAttribute(colors, scene::Format::unorm8x4);
  return std::make_shared<const scene::Snapshot>(makeSnapshot({mesh}));
}

}  // namespace gluray::test

#include "bench/render/wavelet_snapshot.h"

#include <cmath>
#include <memory>

namespace gluray::bench {
namespace {

scene::Attribute attribute(const void* data, uint32_t stride, scene::Format format) {
  // The owner has nothing to free, because the mesh outlives the renderer. It lives as long as the attribute,
  // which names of arrays depend on.
  return {std::shared_ptr<const void>(data, [](const void*) {}), static_cast<const std::byte*>(data), stride,
          format};
}

scene::MeshPtr toScene(const TriangleMesh& mesh) {
  auto out = std::make_shared<scene::Mesh>();
  out->geometryId = {1, mesh.triangleCount()};
  out->triangleCount = static_cast<uint32_t>(mesh.triangleCount());
  out->vertexCount = static_cast<uint32_t>(mesh.normals.size());
  out->positions = attribute(mesh.positions.data(), sizeof(Vertex), scene::Format::float3);
  out->normals = attribute(mesh.normals.data(), sizeof(Vertex), scene::Format::float3);
  out->indices = attribute(mesh.indices.data(), 4, scene::Format::uint32);
  return out;
}

}  // namespace

scene::Snapshot waveletSnapshot(const TriangleMesh& mesh) {
  scene::Snapshot s;
  s.frame = 1;
  s.camera.viewport = {0, 0, kImageSize, kImageSize};
  s.region = {0, 0, kImageSize, kImageSize};
  const double f = 1 / std::tan(kViewAngle / 2 * M_PI / 180), n = kNear, e = kFar;
  s.camera.clipFromEye =
      glm::dmat4(f, 0, 0, 0, 0, f, 0, 0, 0, 0, -(e + n) / (e - n), -1, 0, 0, -2 * e * n / (e - n), 0);
  scene::Shading shading;
  shading.lighting = true;
  shading.normalize = true;
  scene::Light light;
  light.diffuse = glm::vec4(1);
  shading.lights = {light};
  s.shadings = {shading};
  scene::Instance instance;
  instance.mesh = toScene(mesh);
  scene::Material material;
  material.ambient = material.diffuse = {kDiffuse[0], kDiffuse[1], kDiffuse[2], 1};
  instance.materials = {{material, material}};
  s.instances = {instance};
  return s;
}

void lookFrom(scene::Snapshot& s, const CameraPose& pose) {
  const auto m = eyeFromWorld(pose);
  for (int i = 0; i < 16; ++i) s.eyeFromWorld[i / 4][i % 4] = m[static_cast<size_t>(i)];
  s.instances[0].eyeFromObject = s.eyeFromWorld * glm::dmat4(s.instances[0].worldFromObject);
}

}  // namespace gluray::bench

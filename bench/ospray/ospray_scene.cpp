#include "bench/ospray/ospray_scene.h"

#include <ospray/ospray_util.h>

#include <array>
#include <stdexcept>

namespace gluray::bench {
namespace {

void check(OSPError error, const char* what) {
  if (error != OSP_NO_ERROR) throw std::runtime_error(std::string("OSPRay cannot ") + what);
}

void startDevice(int threads) {
  check(ospLoadModule("cpu"), "load its CPU module");
  OSPDevice device = ospNewDevice("cpu");
  if (threads > 0) ospDeviceSetParam(device, "numThreads", OSP_INT, &threads);
  ospDeviceCommit(device);
  ospSetCurrentDevice(device);
}

/// Shares `count` elements of the mesh's array.
OSPData share(const void* data, OSPDataType type, size_t count) {
  const OSPData shared = ospNewSharedData1D(data, type, count);
  ospCommit(shared);
  return shared;
}

void setDirection(OSPObject object, const char* name, const std::array<double, 3>& v, double sign) {
  const float out[] = {static_cast<float>(sign * v[0]), static_cast<float>(sign * v[1]),
                       static_cast<float>(sign * v[2])};
  ospSetParam(object, name, OSP_VEC3F, out);
}

}  // namespace

OsprayScene::OsprayScene(const TriangleMesh& mesh, const Options& options) {
  startDevice(options.threads);
  camera_ = ospNewCamera("perspective");
  ospSetFloat(camera_, "fovy", static_cast<float>(kViewAngle));
  ospSetFloat(camera_, "aspect", 1);
  renderer_ = ospNewRenderer(options.renderer.c_str());
  if (options.renderer == "scivis") {
    ospSetInt(renderer_, "aoSamples", options.occlusionSamples);
    ospSetFloat(renderer_, "aoDistance", options.occlusionDistance);
    ospSetBool(renderer_, "shadows", options.shadows);
  }
  const float background[] = {kBackground[0], kBackground[1], kBackground[2], 0};
  ospSetParam(renderer_, "backgroundColor", OSP_VEC4F, background);
  ospSetInt(renderer_, "pixelSamples", 1);
  world_ = ospNewWorld();
  makeMesh(mesh, options);
  makeLights();
  film_ = ospNewFrameBuffer(kImageSize, kImageSize, OSP_FB_RGBA8, OSP_FB_COLOR | OSP_FB_ACCUM);
  ospCommit(film_);
  ospCommit(renderer_);
  ospCommit(world_);
}

OsprayScene::~OsprayScene() {
  ospRelease(film_), ospRelease(world_), ospRelease(renderer_), ospRelease(camera_), ospRelease(light_);
  ospShutdown();
}

void OsprayScene::makeMesh(const TriangleMesh& mesh, const Options& options) {
  const OSPGeometry geometry = ospNewGeometry("mesh");
  ospSetObject(geometry, "vertex.position", share(mesh.positions.data(), OSP_VEC3F, mesh.normals.size()));
  ospSetObject(geometry, "vertex.normal", share(mesh.normals.data(), OSP_VEC3F, mesh.normals.size()));
  ospSetObject(geometry, "index", share(mesh.indices.data(), OSP_VEC3UI, mesh.triangleCount()));
  ospCommit(geometry);
  const OSPMaterial material = ospNewMaterial("obj");
  ospSetParam(material, "kd", OSP_VEC3F, kDiffuse.data());
  ospCommit(material);
  const OSPGeometricModel model = ospNewGeometricModel(geometry);
  ospSetObjectAsData(model, "material", OSP_MATERIAL, material);
  ospCommit(model);
  const OSPGroup group = ospNewGroup();
  ospSetObjectAsData(group, "geometry", OSP_GEOMETRIC_MODEL, model);
  ospCommit(group);
  const OSPInstance instance = ospNewInstance(group);
  ospCommit(instance);
  ospSetObjectAsData(world_, "instance", OSP_INSTANCE, instance);
  if (options.renderer != "scivis") return;
  for (OSPObject done : {OSPObject(geometry), OSPObject(material), OSPObject(model), OSPObject(group)})
    ospRelease(done);
}

void OsprayScene::makeLights() {
  light_ = ospNewLight("distant");
  ospSetFloat(light_, "intensity", 2.5f);
  ospSetFloat(light_, "angularDiameter", 3);
  ospCommit(light_);
  const OSPLight ambient = ospNewLight("ambient");
  ospSetFloat(ambient, "intensity", 0.25f);
  ospCommit(ambient);
  const OSPLight lights[] = {light_, ambient};
  const OSPData both = ospNewSharedData1D(lights, OSP_LIGHT, 2), copy = ospNewData(OSP_LIGHT, 2);
  ospCopyData(both, copy);
  ospCommit(copy);
  ospSetObject(world_, "light", copy);
}

void OsprayScene::shine(const std::array<double, 3>& direction) {
  setDirection(light_, "direction", direction, 1);
  ospCommit(light_);
}

void OsprayScene::render(const CameraPose& pose, bool accumulate) {
  setDirection(camera_, "position", pose.eye, 1);
  setDirection(camera_, "direction", pose.backward, -1);
  setDirection(camera_, "up", pose.up, 1);
  ospCommit(camera_);
  if (!accumulate) ospResetAccumulation(film_);
  ospRenderFrameBlocking(film_, renderer_, camera_, world_);
}

std::vector<uint32_t> OsprayScene::pixels() const {
  const void* mapped = ospMapFrameBuffer(film_, OSP_FB_COLOR);
  const auto* first = static_cast<const uint32_t*>(mapped);
  std::vector<uint32_t> copy(first, first + size_t{kImageSize} * kImageSize);
  ospUnmapFrameBuffer(mapped, film_);
  return copy;
}

}  // namespace gluray::bench

#include "accel/tlas.h"

#include "accel/device/embree.h"
#include "accel/device/error.h"
#include "base/timeline.h"

#include <glm/gtc/type_ptr.hpp>

#include <utility>

namespace gluray::accel {

namespace {

RTCScene newScene(const Device& device) {
  const RTCScene scene = rtcNewScene(device.handle());
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST | kFilterInQuery);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
  return scene;
}

}  // namespace

Tlas::Tlas(const Device& device) : device_(device), scene_(newScene(device)) {}

Tlas::~Tlas() { release(); }

void Tlas::release() {
  for (RTCGeometryTy* geometry : geometries_) {
    if (geometry) rtcReleaseGeometry(geometry);
  }
  rtcReleaseScene(scene_);
}

// A scene without instances would keep memory of its structure.
bool Tlas::clear() {
  if (geometries_.empty()) return false;
  release();
  geometries_.clear(), held_.clear();
  scene_ = newScene(device_);
  return true;
}

// Attaches, moves or (null) removes the instance of one index.
void Tlas::placeInstance(size_t index, const PlacedBlas* placed) {
  RTCGeometryTy*& geometry = geometries_[index];
  const auto id = static_cast<unsigned>(index);
  if (!placed || !placed->blas) {
    if (!geometry) return;
    rtcDetachGeometry(scene_, id);
    rtcReleaseGeometry(geometry);
    geometry = nullptr;
    return;
  }
  const bool fresh = !geometry;
  if (fresh) geometry = rtcNewGeometry(device_.handle(), RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, placed->blas->scene());
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                          glm::value_ptr(placed->worldFromObject));
  rtcCommitGeometry(geometry);
  if (fresh) rtcAttachGeometryByID(scene_, geometry, id);
}

bool Tlas::update(std::vector<PlacedBlas> instances, const glm::dmat4& eyeFromWorld) {
  if (instances == held_) return false;
  const size_t before = held_.size();
  for (size_t i = instances.size(); i < geometries_.size(); ++i) placeInstance(i, nullptr);
  geometries_.resize(instances.size());
  for (size_t i = 0; i < instances.size(); ++i) {
    if (i >= before || !(instances[i] == held_[i])) placeInstance(i, &instances[i]);
  }
  // Until the commit succeeds, the contents are unknown: after an error all geometries are placed again.
  std::vector<PlacedBlas> alive = std::exchange(held_, {});
  const timeline::Span span("top level", instances.size());
  commitScene(scene_);
  device_.check("the top-level acceleration structure cannot be built");
  held_ = std::move(instances), heldFrom_ = eyeFromWorld;
  return true;
}

}  // namespace gluray::accel

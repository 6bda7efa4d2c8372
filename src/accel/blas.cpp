#include "accel/blas.h"

#include "accel/background_job.h"
#include "accel/embree.h"
#include "accel/error.h"

namespace gluray::accel {
namespace {

void checkArrays(const scene::Mesh& mesh) {
  const auto misaligned = [](const scene::Attribute& a) {
    return reinterpret_cast<uintptr_t>(a.data) % 4 != 0 || a.stride % 4 != 0;
  };
  if (!mesh.positions || mesh.positions.format != scene::Format::float3 || misaligned(mesh.positions)) {
    throw Error("a mesh has positions that are not three aligned floats");
  }
  if (mesh.indices && (mesh.indices.stride != 4 || misaligned(mesh.indices))) {
    throw Error("a mesh has indices that are not tightly packed");
  }
  if (!mesh.indices && static_cast<uint64_t>(mesh.triangleCount) * 3 > mesh.vertexCount) {
    throw Error("a mesh has fewer vertices than its triangles need");
  }
}

// Robust: rays through shared edges never slip between triangles, as no pixel of a closed surface is left out
// by OpenGL.
RTCSceneFlags sceneFlags(BvhQuality quality) {
  const RTCSceneFlags flags = RTC_SCENE_FLAG_ROBUST | kFilterInQuery;
  return quality == BvhQuality::compact ? flags | RTC_SCENE_FLAG_COMPACT : flags;
}

}  // namespace

Blas::Blas(const Device& device, IotaIndices& iota, const scene::Mesh& mesh, BvhQuality quality)
    : device_(device), positions_(mesh.positions.owner), triangleCount_(mesh.triangleCount) {
  checkArrays(mesh);
  pinnedBytes_ = static_cast<size_t>(mesh.vertexCount) * mesh.positions.stride;
  const void* indexData = mesh.indices.data;
  if (mesh.indices) {
    indices_ = mesh.indices.owner;
    pinnedBytes_ += static_cast<size_t>(mesh.triangleCount) * 12;
  } else {
    auto shared = iota.get(static_cast<size_t>(mesh.triangleCount) * 3);
    indexData = shared.get();
    indices_ = std::shared_ptr<const void>(shared, shared.get());
  }

  const auto rtcQuality = quality == BvhQuality::fast ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
  scene_ = rtcNewScene(device.handle());
  rtcSetSceneBuildQuality(scene_, rtcQuality);
  rtcSetSceneFlags(scene_, sceneFlags(quality));
  RTCGeometry geometry = rtcNewGeometry(device.handle(), RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryBuildQuality(geometry, rtcQuality);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.positions.data, 0,
                             mesh.positions.stride, mesh.vertexCount);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indexData, 0, 12,
                             mesh.triangleCount);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_, geometry, 0);
  rtcReleaseGeometry(geometry);
  try {
    device.check("a mesh cannot be read in place");
  } catch (...) {
    rtcReleaseScene(scene_);
    throw;
  }
}

Blas::~Blas() { rtcReleaseScene(scene_); }

void Blas::commit() {
  {
    const CommitScope scope;
    rtcCommitScene(scene_);
  }
  device_.check("the acceleration structure of a mesh cannot be built");
}

void Blas::build() {
  const size_t before = Device::bytesOfFrames();
  commit();
  const size_t after = Device::bytesOfFrames();
  bvhBytes_ = after > before ? after - before : 0;
}

void Blas::buildBehind(const std::atomic<bool>& cancelled) {
  // While the process exits, TBB does not survive that its tasks are cancelled.
  const auto goOn = [](void* flag, double) {
    parkAtExit();
    return !static_cast<const std::atomic<bool>*>(flag)->load();
  };
  rtcSetSceneProgressMonitorFunction(scene_, goOn, const_cast<std::atomic<bool>*>(&cancelled));
  const BehindScope behind;
  commit();
  rtcSetSceneProgressMonitorFunction(scene_, nullptr, nullptr);
  bvhBytes_ = behind.bytes();
}

}  // namespace gluray::accel

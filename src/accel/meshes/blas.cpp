#include "accel/meshes/blas.h"

#include "accel/device/embree.h"
#include "accel/device/error.h"
#include "accel/impostors/capsule_bundles.h"
#include "accel/queries/impostor_query.h"
#include "base/background_job.h"
#include "base/timeline.h"
#include "parallel/arena.h"

#include <glm/gtc/type_ptr.hpp>

#include <cstring>

namespace gluray::accel {
namespace {

// Robust mode is watertight: no ray passes between triangles at a shared edge, as OpenGL skips no pixel of a
// closed surface.
RTCSceneFlags sceneFlags(BvhQuality quality) {
  const RTCSceneFlags flags = RTC_SCENE_FLAG_ROBUST | kFilterInQuery;
  const bool small = quality == BvhQuality::compact || quality == BvhQuality::least;
  return small ? flags | RTC_SCENE_FLAG_COMPACT : flags;
}

/// Embree's callback. Embree leaves out impostors with lower > upper, which do not exist.
void impostorBounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& [mesh, reach] =
      *static_cast<const std::pair<const scene::Mesh*, const ImpostorReach*>*>(arguments->geometryUserPtr);
  const Box box = boundsOfImpostor(*mesh, *reach, arguments->primID);
  RTCBounds& out = *arguments->bounds_o;
  out.lower_x = box.lower.x, out.lower_y = box.lower.y, out.lower_z = box.lower.z;
  out.upper_x = box.upper.x, out.upper_y = box.upper.y, out.upper_z = box.upper.z;
}

}  // namespace

void checkArrays(const scene::Mesh& mesh) {
  const auto misaligned = [](const scene::Attribute& a) {
    return reinterpret_cast<uintptr_t>(a.data) % 4 != 0 || a.stride % 4 != 0;
  };
  if (!mesh.positions || mesh.positions.format != scene::Format::float3 || misaligned(mesh.positions)) {
    throw Error("a mesh has positions that are not three aligned floats", scene::Loss::draws);
  }
  if (mesh.indices && (mesh.indices.stride != 4 || misaligned(mesh.indices))) {
    throw Error("a mesh has indices that are not tightly packed", scene::Loss::draws);
  }
  if (!mesh.indices && uint64_t{mesh.triangleCount} * scene::cornersOf(mesh.shape) > mesh.vertexCount) {
    throw Error("a mesh has fewer vertices than its primitives need", scene::Loss::draws);
  }
}

Hash128 Geometry::id() const {
  if (mesh->shape == scene::Shape::triangles) return mesh->geometryId;
  const glm::vec3* rows[] = {&reach.perRadius,    &reach.alongAxis[0], &reach.alongAxis[1],
                             &reach.alongAxis[2], &reach.perLength,    &reach.further};
  Hash128 id = mesh->geometryId;
  for (const glm::vec3* row : rows) {
    const glm::vec3 values = *row + 0.0f;  // -0 is 0
    id = hashBytes(glm::value_ptr(values), sizeof values, id);
  }
  return id;
}

Blas::Blas(const Device& device, IotaIndices& iota, const Geometry& of, BvhQuality quality)
    : Blas(device, iota, of, quality, false) {}

BlasPtr Blas::createToRefit(const Device& device, IotaIndices& iota, const Geometry& of) {
  BlasPtr blas(new Blas(device, iota, of, BvhQuality::fast, true));
  if (allInReach(*of.mesh)) blas->neighbours_ = std::make_unique<Neighbours>(*of.mesh);
  return blas;
}

BlasPtr Blas::createRefitted(Blas& from, const scene::Mesh& mesh) { return BlasPtr(new Blas(from, mesh)); }

Blas::Blas(Blas& from, const scene::Mesh& mesh)
    : device_(from.device_),
      indices_(from.indices_),
      bvhBytes_(from.bvhBytes_),
      triangleCount_(from.triangleCount_),
      vertexCount_(from.vertexCount_),
      indexData_(from.indexData_),
      neighbours_(std::move(from.neighbours_)),
      scene_(from.scene()) {
  rtcRetainScene(scene());
  const RTCGeometry geometry = rtcGetGeometry(scene(), 0);
  setPositions(geometry, mesh);
  rtcCommitGeometry(geometry);
}

void Blas::setPositions(RTCGeometryTy* geometry, const scene::Mesh& mesh) {
  positions_ = mesh.positions.owner;
  pinnedBytes_ = static_cast<size_t>(mesh.vertexCount) * mesh.positions.stride +
                 (indexData_ ? static_cast<size_t>(mesh.triangleCount) * 12 : 0);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.positions.data, 0,
                             mesh.positions.stride, mesh.vertexCount);
}

bool Blas::hasTopologyOf(const scene::Mesh& mesh) const {
  if (isSpecial_ || mesh.shape != scene::Shape::triangles || mesh.triangleCount != triangleCount_ ||
      mesh.vertexCount != vertexCount_ || !mesh.indices != !indexData_)
    return false;
  return !indexData_ || mesh.indices.data == indexData_ ||
         std::memcmp(mesh.indices.data, indexData_, static_cast<size_t>(triangleCount_) * 12) == 0;
}

double Blas::spreadIn(const scene::Mesh& mesh) const {
  return neighbours_ && allInReach(mesh) ? neighbours_->spreadIn(mesh) : 0;
}

Blas::Blas(const Device& device, IotaIndices& iota, const Geometry& of, BvhQuality quality, bool toRefit)
    : device_(device),
      positions_(of.mesh->positions.owner),
      triangleCount_(of.mesh->triangleCount),
      vertexCount_(of.mesh->vertexCount),
      isSpecial_(of.mesh->shape != scene::Shape::triangles) {
  const scene::Mesh& mesh = *of.mesh;
  checkArrays(mesh);
  pinnedBytes_ = static_cast<size_t>(mesh.vertexCount) * mesh.positions.stride;
  const auto rtcQuality = quality == BvhQuality::fast ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
  scene_.reset(rtcNewScene(device.handle()));
  rtcSetSceneBuildQuality(scene(), rtcQuality);
  rtcSetSceneFlags(scene(), toRefit ? sceneFlags(quality) | RTC_SCENE_FLAG_DYNAMIC : sceneFlags(quality));
  RTCGeometry geometry = nullptr;
  if (mesh.shape != scene::Shape::triangles) geometry = impostors(of, quality);
  if (!geometry && (quality == BvhQuality::least || (quality == BvhQuality::fast && !toRefit))) {
    const auto aim = quality == BvhQuality::least ? TriangleBlocks::Aim::memory : TriangleBlocks::Aim::speed;
    geometry = bundles(mesh);
    if (!geometry) geometry = blocks(mesh, aim);
  }
  if (!geometry) geometry = triangles(iota, mesh);
  rtcSetGeometryBuildQuality(geometry, toRefit ? RTC_BUILD_QUALITY_REFIT : rtcQuality);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene(), geometry, 0);
  rtcReleaseGeometry(geometry);
  device.check("a mesh cannot be read in place");
}

RTCGeometryTy* Blas::triangles(IotaIndices& iota, const scene::Mesh& mesh) {
  const void* indexData = mesh.indices.data;
  if (mesh.indices) {
    indices_ = mesh.indices.owner;
    indexData_ = mesh.indices.data;
  } else {
    auto shared = iota.get(static_cast<size_t>(mesh.triangleCount) * 3);
    indexData = shared.get();
    indices_ = std::shared_ptr<const void>(shared, shared.get());
  }
  RTCGeometry geometry = rtcNewGeometry(device_.handle(), RTC_GEOMETRY_TYPE_TRIANGLE);
  setPositions(geometry, mesh);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indexData, 0, 12,
                             mesh.triangleCount);
  return geometry;
}

namespace {

/// A geometry of `count` primitives that are known by `leaves`.
RTCGeometry userGeometry(const Device& device, uint32_t count, void* leaves, RTCBoundsFunction bounds,
                         RTCIntersectFunctionN intersect, RTCOccludedFunctionN occlude) {
  RTCGeometry geometry = rtcNewGeometry(device.handle(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, count);
  rtcSetGeometryUserData(geometry, leaves);
  rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  rtcSetGeometryOccludedFunction(geometry, occlude);
  return geometry;
}

}  // namespace

RTCGeometryTy* Blas::impostors(const Geometry& of, BvhQuality quality) {
  const scene::Mesh& mesh = *of.mesh;
  impostors_.shape = mesh.shape;
  impostors_.triangleCount = mesh.triangleCount, impostors_.vertexCount = mesh.vertexCount;
  impostors_.positions = mesh.positions, impostors_.indices = mesh.indices;
  impostors_.radii = mesh.radii, impostors_.axes = mesh.axes, impostors_.radius = mesh.radius;
  reach_ = of.reach;
  bounded_ = {&impostors_, &reach_};
  for (const scene::Attribute* a : {&mesh.radii, &mesh.axes})
    if (*a) pinnedBytes_ += static_cast<size_t>(mesh.vertexCount) * a->stride;
  const bool small = quality == BvhQuality::compact || quality == BvhQuality::least;
  if (small || !CapsuleBundles::pay(mesh))
    return userGeometry(device_, mesh.triangleCount, &bounded_, impostorBounds, intersectImpostors,
                        occludeImpostors);
  auto bundles = std::make_shared<CapsuleBundles>(device_, impostors_, reach_, quality == BvhQuality::fast);
  leafBytes_ = HeldBytes(bundles->bytes());
  userData_ = bundles;
  return userGeometry(device_, bundles->count(), bundles.get(), capsuleBundleBounds, intersectCapsuleBundles,
                      occludeCapsuleBundles);
}

RTCGeometryTy* Blas::blocks(const scene::Mesh& mesh, TriangleBlocks::Aim aim) {
  auto blocks = std::make_unique<TriangleBlocks>(mesh, aim);
  if (!blocks->pay()) return nullptr;
  blocks_ = std::move(blocks);
  leafBytes_ = HeldBytes(blocks_->bytes());
  pinIndices(mesh);
  return userGeometry(device_, blocks_->count(), blocks_.get(), triangleBlockBounds, intersectTriangleBlocks,
                      occludeTriangleBlocks);
}

RTCGeometryTy* Blas::bundles(const scene::Mesh& mesh) {
  if (mesh.triangleCount >= TriangleBundles::kSampled && !TriangleBundles::likely(mesh)) return nullptr;
  auto bundles = std::make_unique<TriangleBundles>(mesh);
  if (!bundles->pay()) return nullptr;
  bundles_ = std::move(bundles);
  leafBytes_ = HeldBytes(bundles_->bytes());
  pinIndices(mesh);
  return userGeometry(device_, bundles_->count(), bundles_.get(), triangleBundleBounds,
                      intersectTriangleBundles, occludeTriangleBundles);
}

void Blas::pinIndices(const scene::Mesh& mesh) {
  indexData_ = mesh.indices.data;
  if (mesh.indices) pinnedBytes_ += static_cast<size_t>(mesh.triangleCount) * 12;
}

Blas::Blas(const Device& device, const scene::Mesh& mesh, UserPrimitives primitives)
    : device_(device),
      triangleCount_(mesh.triangleCount),
      vertexCount_(mesh.vertexCount),
      isSpecial_(true),
      userData_(std::move(primitives.data)) {
  scene_.reset(rtcNewScene(device.handle()));
  rtcSetSceneFlags(scene(), sceneFlags(BvhQuality::compact));
  const RTCGeometry geometry = userGeometry(device, primitives.count, userData_.get(), primitives.bounds,
                                            primitives.intersect, primitives.occlude);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene(), geometry, 0);
  rtcReleaseGeometry(geometry);
}

Blas::~Blas() = default;

void ReleaseScene::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }

void Blas::commit() {
  commitScene(scene());
  if (blocks_) blocks_->forgetBoxes();
  device_.check("the acceleration structure of a mesh cannot be built");
}

void Blas::build() {
  const timeline::Span span("build mesh", triangleCount_);
  const ptrdiff_t before = Device::bytesOfFrames();
  commit();
  const ptrdiff_t grown = Device::bytesOfFrames() - before;
  bvhBytes_ += grown > 0 ? static_cast<size_t>(grown) : 0;
}

BlasPtr Blas::buildAlone(const Device& device, IotaIndices& iota, const Geometry& of, BvhQuality quality) {
  const timeline::Span span("build page", of.mesh->triangleCount);
  Arena alone(1);
  return alone.execute([&] {
    auto blas = std::make_shared<Blas>(device, iota, of, quality);
    const BehindScope behind;
    blas->commit();
    blas->bvhBytes_ = behind.bytes();
    return blas;
  });
}

void Blas::buildBehind(const std::atomic<bool>& cancelled) {
  timeline::nameThread("refining");
  const timeline::Span span("refine mesh", triangleCount_);
  // TBB crashes if its tasks are cancelled while the process exits.
  const auto goOn = [](void* flag, double) {
    parkAtExit();
    return !static_cast<const std::atomic<bool>*>(flag)->load();
  };
  rtcSetSceneProgressMonitorFunction(scene(), goOn, const_cast<std::atomic<bool>*>(&cancelled));
  const BehindScope behind;
  commit();
  rtcSetSceneProgressMonitorFunction(scene(), nullptr, nullptr);
  bvhBytes_ = behind.bytes();
}

}  // namespace gluray::accel

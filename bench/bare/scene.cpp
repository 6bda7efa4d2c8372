#include "bench/bare/scene.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace gluray::bench {
namespace {

constexpr int kTile = 16;   // pixels, both ways
constexpr int kBlock = 4;   // pixels of a packet, both ways
constexpr int kLanes = 16;  // rays of a packet

uint8_t toByte(float value) { return uint8_t(std::lround(255 * std::clamp(value, 0.0f, 1.0f))); }

}  // namespace

BareScene::BareScene(const TriangleMesh& mesh, const std::string& quality, int threads) : mesh_(mesh) {
  device_ = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
  if (!device_) throw std::runtime_error("Embree made no device");
  rtcSetDeviceErrorFunction(
      device_, [](void*, RTCError, const char* text) { std::fprintf(stderr, "Embree: %s\n", text); },
      nullptr);
  scene_ = rtcNewScene(device_);
  if (quality == "compact") rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_COMPACT);
  const RTCBuildQuality build = quality == "fast" ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
  rtcSetSceneBuildQuality(scene_, build);
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryBuildQuality(geometry, build);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.positions.data(), 0,
                             sizeof(Vertex), mesh.positions.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.indices.data(), 0,
                             3 * sizeof(uint32_t), mesh.triangleCount());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
  if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
    throw std::runtime_error("Embree could not build the scene");
}

BareScene::~BareScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void BareScene::render(const CameraPose& pose, std::vector<uint8_t>& rgba) const {
  tbb::parallel_for(tbb::blocked_range2d<int>(0, kImageSize / kTile, 1, 0, kImageSize / kTile, 1),
                    [&](const tbb::blocked_range2d<int>& tiles) {
                      for (int y = tiles.rows().begin(); y < tiles.rows().end(); ++y)
                        for (int x = tiles.cols().begin(); x < tiles.cols().end(); ++x)
                          renderTile(pose, x * kTile, y * kTile, rgba.data());
                    });
}

void BareScene::renderTile(const CameraPose& pose, int tileX, int tileY, uint8_t* rgba) const {
  const float pixel = float(2 * std::tan(kViewAngle / 2 * M_PI / 180) / kImageSize);  // at distance 1
  float right[3], up[3], ahead[3];
  for (size_t axis = 0; axis < 3; ++axis) {
    right[axis] = float(pose.right[axis]);
    up[axis] = float(pose.up[axis]);
    ahead[axis] = float(-pose.backward[axis]);
  }
  alignas(64) int valid[kLanes];
  std::fill_n(valid, kLanes, -1);
  for (int blockY = tileY; blockY < tileY + kTile; blockY += kBlock)
    for (int blockX = tileX; blockX < tileX + kTile; blockX += kBlock) {
      alignas(64) RTCRayHit16 rays;
      // One ray through each pixel's centre, with a direction of length 1 along the view axis: t is eye-space
      // depth.
      for (int lane = 0; lane < kLanes; ++lane) {
        const float sx = (float(blockX + lane % kBlock) + 0.5f - kImageSize / 2) * pixel;
        const float sy = (float(blockY + lane / kBlock) + 0.5f - kImageSize / 2) * pixel;
        rays.ray.org_x[lane] = float(pose.eye[0]);
        rays.ray.org_y[lane] = float(pose.eye[1]);
        rays.ray.org_z[lane] = float(pose.eye[2]);
        rays.ray.dir_x[lane] = ahead[0] + sx * right[0] + sy * up[0];
        rays.ray.dir_y[lane] = ahead[1] + sx * right[1] + sy * up[1];
        rays.ray.dir_z[lane] = ahead[2] + sx * right[2] + sy * up[2];
        rays.ray.tnear[lane] = float(kNear);
        rays.ray.tfar[lane] = float(kFar);
        rays.ray.time[lane] = 0;
        rays.ray.mask[lane] = 0xffffffffu;
        rays.ray.flags[lane] = 0;
        rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      }
      intersectCoherent(valid, scene_, rays);
      for (int lane = 0; lane < kLanes; ++lane) {
        const int x = blockX + lane % kBlock, y = blockY + lane / kBlock;
        uint8_t* out = rgba + 4 * (size_t(y) * kImageSize + size_t(x));
        out[3] = 255;
        if (rays.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) {
          for (size_t c = 0; c < 3; ++c) out[c] = toByte(kBackground[c]);
          continue;
        }
        // Interpolated normal; the light shines along the view axis.
        const uint32_t* corner = mesh_.indices.data() + 3 * size_t(rays.hit.primID[lane]);
        const Vertex &a = mesh_.normals[corner[0]], &b = mesh_.normals[corner[1]],
                     &c = mesh_.normals[corner[2]];
        const float u = rays.hit.u[lane], v = rays.hit.v[lane], w = 1 - u - v;
        const float nx = w * a.x + u * b.x + v * c.x, ny = w * a.y + u * b.y + v * c.y,
                    nz = w * a.z + u * b.z + v * c.z;
        const float towards = -(nx * ahead[0] + ny * ahead[1] + nz * ahead[2]);
        const float light = 0.2f + std::max(0.0f, towards) / std::sqrt(nx * nx + ny * ny + nz * nz);
        for (size_t i = 0; i < 3; ++i) out[i] = toByte(kDiffuse[i] * light);
      }
    }
}

}  // namespace gluray::bench

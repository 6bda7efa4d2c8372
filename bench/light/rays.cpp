#include "bench/light/rays.h"

#include "bench/bare/embree.h"
#include "bench/bare/scene.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace gluray::bench {
namespace {

constexpr int kLanes = 16;

struct Packet {
  alignas(64) int valid[kLanes];
  RTCRay16 rays;
};

/// Points and normals through the centres of 4x4 pixels, then directions about the normals.
struct Aim {
  const TriangleMesh& mesh;
  const CameraPose& pose;
  const BareAim& to;

  /// One of 16 strata of the cosine-weighted hemisphere about the normal, or of the light, by bits of the
  /// lane. False: the light is behind the surface.
  bool direct(int lane, const float (&normal)[3], RTCRay16& ray) const {
    double n[] = {normal[0], normal[1], normal[2]};
    const double a = ((lane & 3) + 0.5) / 4, b = ((lane >> 2) + 0.5) / 4;
    double z = std::sqrt(1 - a);
    if (to.towardsLight) {
      const double facing = n[0] * to.light[0] + n[1] * to.light[1] + n[2] * to.light[2];
      std::copy(to.light.begin(), to.light.end(), n);
      z = 1 - a * (1 - std::cos(to.angle / 2 * M_PI / 180));
      if (facing <= 0) return false;
    }
    const double r = std::sqrt(1 - z * z), x = r * std::cos(2 * M_PI * b), y = r * std::sin(2 * M_PI * b);
    const double sign = std::copysign(1.0, n[2]), c = -1 / (sign + n[2]), d = n[0] * n[1] * c;
    const double t[] = {1 + sign * n[0] * n[0] * c, sign * d, -sign * n[0]},
                 s[] = {d, sign + n[1] * n[1] * c, -n[1]};
    ray.dir_x[lane] = float(x * t[0] + y * s[0] + z * n[0]);
    ray.dir_y[lane] = float(x * t[1] + y * s[1] + z * n[1]);
    ray.dir_z[lane] = float(x * t[2] + y * s[2] + z * n[2]);
    return true;
  }

  bool above(int lane, const RTCRayHit16& hit, Packet& out) const {
    const uint32_t* corner = mesh.indices.data() + 3 * size_t(hit.hit.primID[lane]);
    const float u = hit.hit.u[lane], v = hit.hit.v[lane], w = 1 - u - v;
    const Vertex &a = mesh.normals[corner[0]], &b = mesh.normals[corner[1]], &c = mesh.normals[corner[2]];
    float n[] = {w * a.x + u * b.x + v * c.x, w * a.y + u * b.y + v * c.y, w * a.z + u * b.z + v * c.z};
    const float towards =
        n[0] * hit.ray.dir_x[lane] + n[1] * hit.ray.dir_y[lane] + n[2] * hit.ray.dir_z[lane];
    const float scale = (towards > 0 ? -1 : 1) / std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (float& x : n) x *= scale;
    const float t = hit.ray.tfar[lane], lift = 1e-6f * t;
    out.rays.org_x[lane] = hit.ray.org_x[lane] + t * hit.ray.dir_x[lane] + lift * n[0];
    out.rays.org_y[lane] = hit.ray.org_y[lane] + t * hit.ray.dir_y[lane] + lift * n[1];
    out.rays.org_z[lane] = hit.ray.org_z[lane] + t * hit.ray.dir_z[lane] + lift * n[2];
    out.rays.tnear[lane] = 0,
    out.rays.tfar[lane] = to.length > 0 ? float(to.length) : std::numeric_limits<float>::infinity();
    out.rays.time[lane] = 0, out.rays.mask[lane] = ~0u, out.rays.flags[lane] = 0;
    return direct(lane, n, out.rays);
  }
};

void aimPacket(const BareScene& scene, const Aim& aim, int blockX, int blockY, Packet& out) {
  alignas(64) int valid[kLanes];
  std::fill_n(valid, kLanes, -1);
  alignas(64) RTCRayHit16 rays;
  const float pixel = float(2 * std::tan(kViewAngle / 2 * M_PI / 180) / kImageSize);
  for (int i = 0; i < kLanes; ++i) {
    const double sx = (blockX + i % 4 + 0.5 - kImageSize / 2) * pixel,
                 sy = (blockY + i / 4 + 0.5 - kImageSize / 2) * pixel;
    float* const org[] = {rays.ray.org_x + i, rays.ray.org_y + i, rays.ray.org_z + i};
    float* const dir[] = {rays.ray.dir_x + i, rays.ray.dir_y + i, rays.ray.dir_z + i};
    for (size_t c = 0; c < 3; ++c) {
      *org[c] = float(aim.pose.eye[c]);
      *dir[c] = float(sx * aim.pose.right[c] + sy * aim.pose.up[c] - aim.pose.backward[c]);
    }
    rays.ray.tnear[i] = float(kNear), rays.ray.tfar[i] = float(kFar), rays.ray.time[i] = 0;
    rays.ray.mask[i] = ~0u, rays.ray.flags[i] = 0, rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
  intersectCoherent(valid, scene.scene(), rays);
  for (int i = 0; i < kLanes; ++i) {
    out.valid[i] = rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? 0 : -1;
    if (out.valid[i] && !aim.above(i, rays, out)) out.valid[i] = 0;
  }
}

}  // namespace

BareRays shootBareRays(const TriangleMesh& mesh, const CameraPose& pose, const BareAim& to, int threads,
                       int rounds) {
  const int most = threads > 0 ? threads : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, size_t(most));
  const BareScene scene(mesh, "full", most);
  const Aim aim{mesh, pose, to};
  constexpr int kTiles = kImageSize / 32;
  const auto eachPacket = [](const auto& work) {
    tbb::parallel_for(0, kTiles * kTiles, [&](int tile) {
      for (int i = 0; i < 64; ++i)
        work(tile % kTiles * 32 + i % 8 * 4, tile / kTiles * 32 + i / 8 * 4, tile * 64 + i);
    });
  };
  std::vector<Packet> packets(size_t{kTiles} * kTiles * 64);
  eachPacket([&](int x, int y, int i) { aimPacket(scene, aim, x, y, packets[size_t(i)]); });
  BareRays result;
  for (const Packet& packet : packets)
    result.rays += size_t(std::count(packet.valid, packet.valid + kLanes, -1));
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    eachPacket([&](int, int, int i) {
      const Packet& packet = packets[size_t(i)];
      if (std::none_of(packet.valid, packet.valid + kLanes, [](int v) { return v; })) return;
      RTCRay16 rays = packet.rays;
      occludedIncoherent(packet.valid, scene.scene(), rays);
    });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.seconds = round == 0 ? seconds : std::min(result.seconds, seconds);
  }
  return result;
}

}  // namespace gluray::bench

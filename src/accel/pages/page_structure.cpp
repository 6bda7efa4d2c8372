#include "accel/pages/page_structure.h"

#include "accel/device/embree.h"
#include "accel/pages/page.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace gluray::accel {
namespace {

constexpr unsigned kMaxRays = 16;
// Primitives of a page's structure. The box of the whole mesh, on which nothing lies, gives the scene the
// bounds that it has where the mesh is not cut into pages.
constexpr unsigned kWhole = 1;

/// Whether the ray may meet something in the box.
bool meets(const Bounds& box, RTCRayN* ray, unsigned count, unsigned i) {
  constexpr float kSlack = 1 + 1e-5f;
  const glm::vec3 org = originOf(ray, count, i), dir = directionOf(ray, count, i);
  float from = RTCRayN_tnear(ray, count, i), to = RTCRayN_tfar(ray, count, i);
  if (!(to >= from)) return false;
  for (int c = 0; c < 3; ++c) {
    const float a = (box.lower[c] - org[c]) / dir[c], b = (box.upper[c] - org[c]) / dir[c];
    if (std::isnan(a) || std::isnan(b)) continue;  // along the face of the box
    from = std::max(from, std::min(a, b) / kSlack), to = std::min(to, std::max(a, b) * kSlack);
  }
  return from <= to;
}

struct Lanes {
  alignas(64) int valid[kMaxRays] = {};
  bool any = false;
};

Lanes lanesThatMeet(const Bounds& box, const int* valid, RTCRayN* ray, unsigned count) {
  Lanes lanes;
  for (unsigned i = 0; i < count && i < kMaxRays; ++i)
    if (valid[i] == -1 && meets(box, ray, count, i)) lanes.valid[i] = -1, lanes.any = true;
  return lanes;
}

Page& pageOf(void* user) { return *static_cast<Page*>(user); }

void pageBounds(const RTCBoundsFunctionArguments* arguments) {
  const Page& page = pageOf(arguments->geometryUserPtr);
  Bounds box = page.bounds();
  if (arguments->primID == kWhole) box = {page.whole()->lower, page.whole()->upper};
  RTCBounds& out = *arguments->bounds_o;
  out.lower_x = box.lower.x, out.lower_y = box.lower.y, out.lower_z = box.lower.z;
  out.upper_x = box.upper.x, out.upper_y = box.upper.y, out.upper_z = box.upper.z;
}

void intersectPage(const RTCIntersectFunctionNArguments* arguments) {
  const RTCIntersectFunctionNArguments& a = *arguments;
  Page& page = pageOf(a.geometryUserPtr);
  if (a.primID == kWhole) return;
  const Lanes lanes = lanesThatMeet(page.widened(), a.valid, RTCRayHitN_RayN(a.rayhit, a.N), a.N);
  if (!lanes.any) return;
  RTCSceneTy* const scene = page.enter();
  if (!scene) return;
  intersectWithin(a.context, scene, a.N, lanes.valid, a.rayhit);
  page.leave();
}

void occludePage(const RTCOccludedFunctionNArguments* arguments) {
  const RTCOccludedFunctionNArguments& a = *arguments;
  Page& page = pageOf(a.geometryUserPtr);
  if (a.primID == kWhole) return;
  const Lanes lanes = lanesThatMeet(page.widened(), a.valid, a.ray, a.N);
  if (!lanes.any) return;
  RTCSceneTy* const scene = page.enter();
  if (!scene) return;
  occludeWithin(a.context, scene, a.N, lanes.valid, a.ray);
  page.leave();
}

}  // namespace

BlasPtr createPage(const Device& device, PageCache& pages, const scene::Mesh& mesh) {
  auto page = std::make_shared<Page>(pages, mesh);
  const uint32_t boxes = page->whole() ? 2 : 1;
  return std::make_shared<Blas>(
      device, mesh, UserPrimitives{boxes, std::move(page), pageBounds, intersectPage, occludePage});
}

}  // namespace gluray::accel

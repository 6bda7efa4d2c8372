#include "accel/impostors/capsule_bundles.h"

#include "accel/device/embree.h"
#include "accel/device/error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>

namespace gluray::accel {
namespace {

using Primitives = std::vector<RTCBuildPrimitive>;

/// The capsules that exist, with their boxes.
Primitives boxesOf(const scene::Mesh& mesh, const ImpostorReach& reach) {
  Primitives all(mesh.triangleCount);
  tbb::parallel_for(uint32_t{0}, mesh.triangleCount, [&](uint32_t i) {
    const Box box = boundsOfImpostor(mesh, reach, i);
    all[i] = {box.lower.x, box.lower.y, box.lower.z, 0, box.upper.x, box.upper.y, box.upper.z, i};
  });
  std::erase_if(all, [](const RTCBuildPrimitive& p) { return !(p.lower_x <= p.upper_x); });
  return all;
}

/// The leaves that Embree's builder makes, as ranges of a list of primitives.
struct Leaves {
  std::vector<uint32_t> primitives;
  std::vector<std::pair<uint32_t, uint32_t>> ranges;  // first, count
  std::atomic<uint32_t> used = 0, count = 0;

  explicit Leaves(size_t most) : primitives(most), ranges(most) {}
  void add(const RTCBuildPrimitive* from, size_t n) {
    const uint32_t first = used.fetch_add(static_cast<uint32_t>(n));
    for (size_t i = 0; i < n; ++i) primitives[first + i] = from[i].primID;
    ranges[count.fetch_add(1)] = {first, static_cast<uint32_t>(n)};
  }
};

// Of the tree itself nothing is kept.
char kept;
void* createNode(RTCThreadLocalAllocator, unsigned, void*) { return &kept; }
void setChildren(void*, void**, unsigned, void*) {}
void setBounds(void*, const RTCBounds**, unsigned, void*) {}
void* createLeaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* from, size_t n, void* leaves) {
  static_cast<Leaves*>(leaves)->add(from, n);
  return &kept;
}

struct ReleaseBvh {
  void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};

// Embree refuses deeper trees; by default, those of more than 32 levels. Where lines converge at a point, a
// level may part little from the rest: at most as often as the exponents and digits of three floats differ.
constexpr unsigned kMaxDepth = 1024;

void group(const Device& device, Primitives& primitives, bool fast, Leaves& leaves) {
  const std::unique_ptr<std::remove_pointer_t<RTCBVH>, ReleaseBvh> bvh(rtcNewBVH(device.handle()));
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.byteSize = sizeof arguments;
  arguments.buildQuality = fast ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = 2, arguments.maxDepth = kMaxDepth;
  arguments.sahBlockSize = arguments.minLeafSize = arguments.maxLeafSize = CapsuleBundle::kMost;
  arguments.bvh = bvh.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = createNode, arguments.createLeaf = createLeaf;
  arguments.setNodeChildren = setChildren, arguments.setNodeBounds = setBounds;
  arguments.userPtr = &leaves;
  rtcBuildBVH(&arguments);
  device.check("capsules cannot be grouped");
}

void fill(const scene::Mesh& mesh, const uint32_t* primitives, uint32_t count, CapsuleBundle& out) {
  out.count = count;
  for (uint32_t k = 0; k < CapsuleBundle::kMost; ++k) {
    const uint32_t primitive = primitives[k < count ? k : 0];
    const glm::vec3 a = mesh.position(mesh.corner(primitive, 0)),
                    b = mesh.position(mesh.corner(primitive, 1));
    out.primitive[k] = primitive;
    for (int c = 0; c < 3; ++c)
      out.middle[c][k] = 0.5f * a[c] + 0.5f * b[c], out.half[c][k] = 0.5f * (b[c] - a[c]);
  }
}

}  // namespace

CapsuleBundles::CapsuleBundles(const Device& device, const scene::Mesh& mesh, const ImpostorReach& reach,
                               bool fast)
    : mesh_(mesh), reach_(reach) {
  Primitives primitives = boxesOf(mesh, reach);
  Leaves leaves(primitives.size());
  if (!primitives.empty()) group(device, primitives, fast, leaves);
  bundles_.resize(leaves.count);
  tbb::parallel_for(uint32_t{0}, count(), [&](uint32_t i) {
    const auto [first, n] = leaves.ranges[i];
    fill(mesh, leaves.primitives.data() + first, n, bundles_[i]);
  });
}

Box CapsuleBundles::boxOf(uint32_t bundle) const {
  const CapsuleBundle& b = bundles_[bundle];
  Box all{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
  for (uint32_t k = 0; k < b.count; ++k) {
    const Box box = boundsOfImpostor(mesh_, reach_, b.primitive[k]);
    all.lower = glm::min(all.lower, box.lower), all.upper = glm::max(all.upper, box.upper);
  }
  return all;
}

}  // namespace gluray::accel

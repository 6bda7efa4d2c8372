#include "accel/blocks/triangle_bundles.h"

#include "accel/blocks/triangle_block_bounds.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gluray::accel {
namespace {

constexpr TriangleBlockLimits kBlockLimits{4, 2};  // measured in docs/adr/0026
constexpr float kLooser = 3;  // as TriangleBlockLimits::looser, for the blocks of a bundle
constexpr float kFarAway = std::numeric_limits<float>::infinity();

/// Blocks of some triangles, and which of them make bundles. Memory that is used again.
struct FoundBlocks {
  std::vector<uint32_t> first;  // triangle of each block, and the end of the last
  std::vector<Box> boxes;
  std::vector<uint64_t> order, sorted;  // Morton code and, in the lower half, number of existing blocks
  std::vector<uint32_t> bundles;        // where each begins in `order`, and the end of the last
};

bool exists(const Box& box) { return box.lower.x <= box.upper.x; }

float halfArea(const Box& box) {
  const glm::vec3 d = box.upper - box.lower;
  return d.x * (d.y + d.z) + d.y * d.z;
}

Box joined(const Box& a, const Box& b) { return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)}; }

constexpr uint32_t kCodeBits = 10;  // for each axis

/// Puts two zeros between the lowest kCodeBits bits.
uint32_t spread(uint32_t x) {
  x = (x | x << 16) & 0x030000FF;
  x = (x | x << 8) & 0x0300F00F;
  x = (x | x << 4) & 0x030C30C3;
  return (x | x << 2) & 0x09249249;
}

/// Sets f.order to the existing blocks, with the Morton codes of their centres within the box of all.
void findCodes(FoundBlocks& f) {
  f.order.clear();
  Box all{glm::vec3(kFarAway), glm::vec3(-kFarAway)};
  for (const Box& box : f.boxes)
    if (exists(box)) all = joined(all, box);
  constexpr float kMinSize = 1e-30f;  // the scale stays finite
  const glm::vec3 size = glm::max(all.upper - all.lower, glm::vec3(kMinSize));
  const glm::vec3 scale = static_cast<float>(1 << kCodeBits) * 0.4999f / size;  // of twice the centre
  for (size_t b = 0; b < f.boxes.size(); ++b) {
    const Box& box = f.boxes[b];
    if (!exists(box)) continue;
    const glm::uvec3 cell((box.lower - all.lower + (box.upper - all.lower)) * scale);
    const uint32_t code = spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2;
    f.order.push_back(uint64_t{code} << 32 | b);
  }
}

/// Sorts f.order by code: radix sort from the lowest digit.
void sortCodes(FoundBlocks& f) {
  f.sorted.resize(f.order.size());
  for (uint32_t shift = 32; shift < 32 + 3 * kCodeBits; shift += kCodeBits) {
    const auto digit = [&](uint64_t element) { return element >> shift & ((1 << kCodeBits) - 1); };
    uint32_t places[1 << kCodeBits] = {};
    for (const uint64_t element : f.order) ++places[digit(element)];
    uint32_t sum = 0;
    for (uint32_t& place : places) sum += std::exchange(place, sum);
    for (const uint64_t element : f.order) f.sorted[places[digit(element)]++] = element;
    f.order.swap(f.sorted);
  }
}

/// Cuts f.order into bundles.
void cutBundles(FoundBlocks& f) {
  f.bundles.clear();
  Box box{};
  float sum = 0;
  for (uint32_t i = 0; i < f.order.size(); ++i) {
    const Box& own = f.boxes[static_cast<uint32_t>(f.order[i])];
    const float area = halfArea(own);
    if (i > 0 && i - f.bundles.back() < TriangleBundle::kBlocks) {
      const Box both = joined(box, own);
      if (halfArea(both) <= kLooser * (sum + area)) {
        box = both, sum += area;
        continue;
      }
    }
    f.bundles.push_back(i);
    box = own, sum = area;
  }
  f.bundles.push_back(static_cast<uint32_t>(f.order.size()));
}

void findBundles(const TriangleRun& run, FoundBlocks& f) {
  f.first.clear(), f.boxes.clear();
  findTriangleBlocks(run, kBlockLimits, f.first, &f.boxes);
  f.first.push_back(run.end);
  findCodes(f);
  sortCodes(f);
  cutBundles(f);
}

constexpr float kBoxSteps = 255;

// Relative; more than all roundings together when steps are counted, and when kernels decode a face from them
// with a fused multiply-add or without.
constexpr float kRounding = 0x1p-21f;

/// Counts steps, rounded outwards: decoded faces are at or outside those that were counted.
struct StepCounter {
  float base, below, above;  // the latter two per unit

  StepCounter(float from, float step)
      : base(from), below((1 - kRounding) / step), above((1 + kRounding) / step) {}
  uint8_t stepsBelow(float value) const {
    return static_cast<uint8_t>(std::min((value - base) * below, kBoxSteps));
  }
  uint8_t stepsAbove(float value) const {
    return static_cast<uint8_t>(std::min(std::ceil((value - base) * above), kBoxSteps));
  }
};

/// Bundle number `i` of those found.
void fill(const FoundBlocks& f, size_t i, TriangleBundle& bundle) {
  constexpr float kMore = 1 + 0x1p-20f;  // rounding must not leave the last step below the box
  const uint32_t begin = f.bundles[i];
  const auto block = [&](uint32_t b) { return static_cast<uint32_t>(f.order[begin + b]); };
  bundle.blocks = f.bundles[i + 1] - begin;
  bundle.first = f.first[0];
  Box all = f.boxes[block(0)];
  for (uint32_t b = 1; b < bundle.blocks; ++b) all = joined(all, f.boxes[block(b)]);
  const glm::vec3 least(std::numeric_limits<float>::min());
  const glm::vec3 step = glm::max((all.upper - all.lower) * (kMore / kBoxSteps), least);
  for (int axis = 0; axis < 3; ++axis) {
    bundle.base[axis] = all.lower[axis], bundle.step[axis] = step[axis];
    const StepCounter counter(all.lower[axis], step[axis]);
    for (uint32_t b = 0; b < TriangleBundle::kBlocks; ++b) {
      const bool is = b < bundle.blocks;
      const Box& box = is ? f.boxes[block(b)] : all;
      bundle.lower[axis][b] = is ? counter.stepsBelow(box.lower[axis]) : 255;
      bundle.upper[axis][b] = is ? counter.stepsAbove(box.upper[axis]) : 0;
    }
  }
  for (uint32_t b = 0; b < TriangleBundle::kBlocks; ++b) {
    const bool is = b < bundle.blocks;
    bundle.offset[b] = static_cast<uint16_t>(is ? f.first[block(b)] - bundle.first : 0);
    bundle.count[b] = static_cast<uint8_t>(is ? f.first[block(b) + 1] - f.first[block(b)] : 0);
  }
}

bool pays(uint64_t bundles, uint64_t triangles) { return bundles > 0 && bundles * 12 <= triangles; }

}  // namespace

TriangleBundles::TriangleBundles(const scene::Mesh& mesh) {
  mesh_.triangleCount = mesh.triangleCount, mesh_.vertexCount = mesh.vertexCount;
  mesh_.positions = mesh.positions, mesh_.indices = mesh.indices;
  constexpr uint32_t kPart = 1 << 15;  // triangles; TriangleBundle::offset counts them
  const uint32_t parts = (mesh.triangleCount + kPart - 1) / kPart;
  std::vector<uint32_t> counts(parts + 1);
  parts_.resize(parts);
  // Each thread's lists of blocks are used for all its parts: they stay in the caches.
  tbb::enumerable_thread_specific<FoundBlocks> found;
  tbb::parallel_for(uint32_t{0}, parts, [&](uint32_t part) {
    FoundBlocks& f = found.local();
    const uint32_t begin = part * kPart, end = begin + std::min(kPart, mesh_.triangleCount - begin);
    findBundles(trianglesOf(mesh_, begin, end), f);
    const size_t count = f.bundles.size() - 1;
    parts_[part] = std::make_unique_for_overwrite<TriangleBundle[]>(count);
    for (size_t i = 0; i < count; ++i) fill(f, i, parts_[part][i]);
    counts[part] = static_cast<uint32_t>(count);
  });
  size_t total = 0;
  for (const uint32_t count : counts) total += count;
  bundles_.reserve(total);
  for (uint32_t part = 0; part < parts; ++part)
    for (uint32_t i = 0; i < counts[part]; ++i) bundles_.push_back(&parts_[part][i]);
}

TriangleRun TriangleBundles::arrays() const { return trianglesOf(mesh_, 0, 0); }

bool TriangleBundles::likely(const scene::Mesh& mesh) {
  constexpr uint32_t kSamples = 4, kEach = kSampled / kSamples;  // kEach: consecutive triangles per sample
  if (mesh.shape != scene::Shape::triangles || mesh.triangleCount < kSampled) return false;
  FoundBlocks f;
  size_t bundles = 0;
  for (uint32_t i = 0; i < kSamples; ++i) {
    const auto begin = static_cast<uint32_t>(uint64_t{mesh.triangleCount - kEach} * i / (kSamples - 1));
    findBundles(trianglesOf(mesh, begin, begin + kEach), f);
    bundles += f.bundles.size() - 1;
  }
  return pays(bundles, kSampled);
}

bool TriangleBundles::pay() const { return pays(count(), mesh_.triangleCount); }

Box TriangleBundles::boxOf(uint32_t bundle) const {
  const TriangleBundle& of = *bundles_[bundle];
  const glm::vec3 base(of.base[0], of.base[1], of.base[2]), step(of.step[0], of.step[1], of.step[2]);
  return {base, base + kBoxSteps * step};
}

}  // namespace gluray::accel

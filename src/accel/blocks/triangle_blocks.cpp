#include "accel/blocks/triangle_blocks.h"

#include "accel/blocks/triangle_block_bounds.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace gluray::accel {
namespace {

// Measured in docs/adr/0022 and 0026.
constexpr TriangleBlockLimits limitsOf(TriangleBlocks::Aim aim) {
  return aim == TriangleBlocks::Aim::memory ? TriangleBlockLimits{8, 3} : TriangleBlockLimits{4, 2};
}

bool pays(TriangleBlocks::Aim aim, uint64_t blocks, uint64_t triangles) {
  return blocks * (aim == TriangleBlocks::Aim::memory ? 3 : 2) <= triangles;
}

}  // namespace

TriangleBlocks::TriangleBlocks(const scene::Mesh& mesh, Aim aim) : aim_(aim) {
  const bool withBoxes = aim == Aim::speed;
  mesh_.triangleCount = mesh.triangleCount, mesh_.vertexCount = mesh.vertexCount;
  mesh_.positions = mesh.positions, mesh_.indices = mesh.indices;
  struct Part {
    std::vector<uint32_t> first;
    std::vector<Box> boxes;
  };
  constexpr uint32_t kBlock = 1 << 16;  // triangles per task, not per triangle block
  const uint32_t blocks = (mesh.triangleCount + kBlock - 1) / kBlock;
  std::vector<Part> parts(blocks);
  tbb::parallel_for(uint32_t{0}, blocks, [&](uint32_t b) {
    Part& part = parts[b];
    part.first.reserve(kBlock / 4);
    if (withBoxes) part.boxes.reserve(kBlock / 4);
    const uint32_t begin = b * kBlock, end = begin + std::min(kBlock, mesh_.triangleCount - begin);
    findTriangleBlocks(trianglesOf(mesh_, begin, end), limitsOf(aim), part.first,
                       withBoxes ? &part.boxes : nullptr);
  });
  size_t total = 0;
  for (const Part& part : parts) total += part.first.size();
  first_.reserve(total + 1);
  if (withBoxes) boxes_.reserve(total);
  for (Part& part : parts) {
    first_.insert(first_.end(), part.first.begin(), part.first.end());
    boxes_.insert(boxes_.end(), part.boxes.begin(), part.boxes.end());
    part = {};
  }
  first_.push_back(mesh.triangleCount);
}

bool TriangleBlocks::likely(const scene::Mesh& mesh, Aim aim) {
  constexpr uint32_t kSamples = 16, kEach = 256;  // kEach: consecutive triangles per sample
  if (mesh.shape != scene::Shape::triangles || mesh.triangleCount < kSamples * kEach) return false;
  std::vector<uint32_t> first;
  for (uint32_t i = 0; i < kSamples; ++i) {
    const auto begin = static_cast<uint32_t>(uint64_t{mesh.triangleCount - kEach} * i / (kSamples - 1));
    findTriangleBlocks(trianglesOf(mesh, begin, begin + kEach), limitsOf(aim), first, nullptr);
  }
  return pays(aim, first.size(), kSamples * kEach);
}

bool TriangleBlocks::pay() const { return pays(aim_, count(), mesh_.triangleCount); }

Box TriangleBlocks::boxOf(uint32_t block) const {
  if (!boxes_.empty()) return boxes_[block];
  return boxOfTriangleBlock(trianglesOf(mesh_, first(block), first(block + 1)));
}

}  // namespace gluray::accel

#include "accel/blocks/triangle_block_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gluray::accel {
namespace {

constexpr float kFarthest = 1.844e18f;  // Embree ignores larger coordinates
constexpr Box kNothing{glm::vec3(1), glm::vec3(-1)};
using Four = float __attribute__((vector_size(16)));  // x, y, z, 0

struct Grown {
  Four lower = Four{} + INFINITY, upper = Four{} - INFINITY;
  void join(Four p) { lower = p < lower ? p : lower, upper = p > upper ? p : upper; }
  void join(const Grown& o) { join(o.lower), join(o.upper); }
  float halfArea() const {
    const Four d = upper - lower;
    return d[0] * (d[1] + d[2]) + d[1] * d[2];
  }
};

// Reads sixteen bytes per position, as Embree does.
Four positionOf(const TriangleRun& run, size_t corner) {
  const size_t vertex = run.indices ? run.indices[corner] : corner;
  Four p;
  std::memcpy(&p, run.positions + vertex * run.stride, sizeof p);
  p[3] = 0;
  return p;
}

/// Adds a triangle to the box; false if Embree would leave the triangle out.
bool join(const TriangleRun& run, uint32_t triangle, Grown& box) {
  const size_t corner = size_t{triangle} * 3;
  const Four a = positionOf(run, corner), b = positionOf(run, corner + 1), c = positionOf(run, corner + 2);
  const auto near = [](Four p) { return (p < kFarthest) & (p > -kFarthest); };
  const auto all = near(a) & near(b) & near(c);
  if (!(all[0] & all[1] & all[2])) return false;
  box.join(a), box.join(b), box.join(c);
  return true;
}

/// Neither Embree's tests of user geometry nor those of a bundle's blocks are as conservative as Embree's of
/// triangles. The margin is wide enough for rays from a hundred times the extent of a million equal blocks.
/// Boxes in bundles are never smaller.
Box widened(const Grown& grown) {
  constexpr float kOwn = 0x1p-6f, kPlace = 0x1p-20f;
  const glm::vec3 lower(grown.lower[0], grown.lower[1], grown.lower[2]);
  const glm::vec3 upper(grown.upper[0], grown.upper[1], grown.upper[2]);
  const glm::vec3 farthest = glm::max(glm::abs(lower), glm::abs(upper));
  const float margin =
      kOwn * glm::length(upper - lower) + kPlace * std::max({farthest.x, farthest.y, farthest.z});
  return {lower - margin, upper + margin};
}

}  // namespace

TriangleRun trianglesOf(const scene::Mesh& mesh, uint32_t first, uint32_t end) {
  return {mesh.positions.data, mesh.positions.stride, reinterpret_cast<const uint32_t*>(mesh.indices.data),
          first, end};
}

namespace {

/// How many of the triangles from `first` on, at most `Most`, make a block, and its box. 0: the first does
/// not exist. Finds their boxes independently of each other, and first tries whether all fit.
template <uint32_t Most>
uint32_t findBlock(const TriangleRun& run, uint32_t first, float looser, Grown& box) {
  Grown own[Most];
  float area[Most], sum = 0;
  uint32_t existing = 0;
  for (const uint32_t most = std::min(Most, run.end - first); existing < most; ++existing) {
    if (!join(run, first + existing, own[existing])) break;
    area[existing] = own[existing].halfArea();
  }
  box = {};
  for (uint32_t k = 0; k < existing; ++k) box.join(own[k]), sum += area[k];
  if (existing == 0 || box.halfArea() <= looser * sum) return existing;
  box = own[0], sum = area[0];
  for (uint32_t k = 1; k < existing; ++k) {
    Grown both = box;
    both.join(own[k]), sum += area[k];
    if (both.halfArea() > looser * sum) return k;
    box = both;
  }
  return existing;
}

}  // namespace

void findTriangleBlocks(const TriangleRun& run, const TriangleBlockLimits& limits,
                        std::vector<uint32_t>& first, std::vector<Box>* boxes) {
  for (uint32_t t = run.first; t < run.end;) {
    Grown box;
    const uint32_t count = limits.most == 4 ? findBlock<4>(run, t, limits.looser, box)
                                            : findBlock<8>(run, t, limits.looser, box);
    first.push_back(t);
    if (boxes) boxes->push_back(count ? widened(box) : kNothing);
    t += std::max(count, 1u);
  }
}

Box boxOfTriangleBlock(const TriangleRun& run) {
  Grown box;
  for (uint32_t t = run.first; t < run.end; ++t)
    if (!join(run, t, box)) return kNothing;
  return widened(box);
}

}  // namespace gluray::accel

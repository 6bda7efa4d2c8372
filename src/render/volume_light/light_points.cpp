#include "render/volume_light/light_points.h"

#include "render/remote/remote_surfaces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace gluray::render {
namespace {

/// Cells that show something, and their neighbours: those between whose middles samples with an opacity lie.
std::vector<uint32_t> litCells(const Lattice& lattice) {
  std::vector<uint32_t> cells;
  const glm::ivec3 size = lattice.size;
  const auto shows = [&](const glm::ivec3& middle) {
    const glm::ivec3 first = glm::max(middle - 1, 0), last = glm::min(middle + 1, size - 1);
    for (int z = first.z; z <= last.z; ++z)
      for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
          if (lattice.values[lattice.index({x, y, z})] > 0) return true;
    return false;
  };
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        if (shows({x, y, z})) cells.push_back(static_cast<uint32_t>(lattice.index({x, y, z})));
  return cells;
}

/// Two numbers in 0 .. 1 that differ from cell to cell.
glm::vec2 shiftOf(uint32_t cell) {
  uint32_t h = cell * 0x9E3779B1u;
  h ^= h >> 15, h *= 0x85EBCA77u, h ^= h >> 13;
  return glm::vec2(static_cast<float>(h & 0xffff), static_cast<float>(h >> 16)) / 65536.0f;
}

/// Direction `i` of `count` that are spread evenly over the sphere: a Fibonacci lattice.
glm::vec3 direction(int i, int count, const glm::vec2& shift) {
  constexpr float kGolden = 0.61803399f, kTurn = 6.2831853f;
  const float u = glm::fract((static_cast<float>(i) + 0.5f) / static_cast<float>(count) + shift.x);
  const float angle = kTurn * glm::fract(static_cast<float>(i) * kGolden + shift.y);
  const float z = 1 - 2 * u, radius = std::sqrt(std::max(0.0f, 1 - z * z));
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

constexpr int kDirections = 32;

/// LightPoints::openness() of the shares that pass along all directions. Sorts them.
float opennessOf(std::array<float, kDirections>& shares) {
  constexpr int kMostOpen = kDirections / 8;
  std::partial_sort(shares.begin(), shares.begin() + kMostOpen, shares.end(), std::greater<>());
  const float open = std::accumulate(shares.begin(), shares.begin() + kMostOpen, 0.0f) / kMostOpen;
  if (!(open > 0)) return 1;
  const float mean = std::accumulate(shares.begin(), shares.end(), 0.0f) / kDirections;
  constexpr float kUnhidden = 3;
  return std::min(1.0f, kUnhidden * mean / open);
}

}  // namespace

LightPoints::LightPoints(const FrameData& frame, const Metric& metric, const Occluders& occluders,
                         const PlacedLattice& medium)
    : frame_(frame),
      metric_(metric),
      occluders_(occluders),
      medium_(medium),
      worldFromLattice_(glm::inverse(medium.latticeFromWorld)),
      cells_(litCells(*medium.extinction)) {}

glm::ivec3 LightPoints::cellOf(uint32_t cell) const {
  const glm::uvec3 size(medium_.extinction->size);
  return {cell % size.x, cell / size.x % size.y, cell / (size.x * size.y)};
}

glm::vec3 LightPoints::pointOf(uint32_t cell) const {
  return glm::vec3(worldFromLattice_ * glm::vec4(glm::vec3(cellOf(cell)) + 0.5f, 1));
}

void LightPoints::aim(int lane, const glm::vec3& point, const glm::vec3& direction, float end,
                      accel::OcclusionRays& rays) const {
  const glm::vec3 along = glm::mat3(metric_.worldFromEye) * direction;
  rays.orgX[lane] = point.x, rays.orgY[lane] = point.y, rays.orgZ[lane] = point.z;
  rays.dirX[lane] = along.x, rays.dirY[lane] = along.y, rays.dirZ[lane] = along.z;
  rays.tNear[lane] = 0, rays.tFar[lane] = end;
}

void LightPoints::pass(int count, accel::RayKind kind, accel::OcclusionRays& rays, float* through) const {
  alignas(64) int32_t valid[kLanes];
  for (int i = 0; i < kLanes; ++i) valid[i] = i < count ? -1 : 0;
  const Transmittance light(occluders_);
  const uint32_t blocked = occludedHere(frame_, valid, rays, kind, occluders_.areSolid() ? nullptr : &light,
                                        {.grey = light.through});
  for (int i = 0; i < count; ++i) through[i] = blocked >> i & 1 ? 0 : light.through[i];
}

/// Calls work(cells, their number) for groups of cells, as many as a packet has lanes.
template <class Work>
void LightPoints::eachGroup(const Work& work) const {
  constexpr size_t kGroup = kLanes;
  const size_t groups = (cells_.size() + kGroup - 1) / kGroup;
  tbb::parallel_for(tbb::blocked_range<size_t>(0, groups, 16), [&](const tbb::blocked_range<size_t>& range) {
    for (size_t g = range.begin(); g < range.end(); ++g)
      work(&cells_[g * kGroup], static_cast<int>(std::min(kGroup, cells_.size() - g * kGroup)));
  });
}

std::vector<float> LightPoints::openness(float radius) const {
  std::vector<float> open(medium_.extinction->values.size(), 1.0f);
  eachGroup([&](const uint32_t* cells, int count) {
    accel::OcclusionRays rays;
    std::array<float, kDirections> shares[kLanes];
    for (int k = 0; k < kDirections; ++k) {
      for (int i = 0; i < count; ++i)
        aim(i, pointOf(cells[i]), direction(k, kDirections, shiftOf(cells[i])), radius, rays);
      float through[kLanes];
      pass(count, accel::RayKind::occlusion, rays, through);
      for (int i = 0; i < count; ++i) shares[i][static_cast<size_t>(k)] = through[i];
    }
    for (int i = 0; i < count; ++i) open[cells[i]] = opennessOf(shares[i]);
  });
  return smoothed(open);
}

/// Of neighbouring cells, which share what is noise.
std::vector<float> LightPoints::smoothed(const std::vector<float>& values) const {
  std::vector<float> means = values;
  const Lattice& lattice = *medium_.extinction;
  tbb::parallel_for(size_t{0}, cells_.size(), [&](size_t i) {
    const glm::ivec3 cell = cellOf(cells_[i]), first = glm::max(cell - 1, 0),
                     last = glm::min(cell + 1, lattice.size - 1);
    float sum = 0;
    int count = 0;
    for (int z = first.z; z <= last.z; ++z)
      for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x, ++count) sum += values[lattice.index({x, y, z})];
    means[cells_[i]] = sum / static_cast<float>(count);
  });
  return means;
}

std::vector<float> LightPoints::arriving(const Source& source) const {
  std::vector<float> arrives(medium_.extinction->values.size(), 1.0f);
  eachGroup([&](const uint32_t* cells, int count) {
    accel::OcclusionRays rays;
    for (int i = 0; i < count; ++i) {
      const glm::vec3 point = pointOf(cells[i]);
      const glm::vec3 way = source.position - glm::vec3(metric_.eyeFromWorld * glm::vec4(point, 1));
      const float distance = glm::length(way);
      if (source.positional)
        aim(i, point, distance > 0 ? way / distance : glm::vec3(0, 0, 1), distance, rays);
      else
        aim(i, point, source.towards, std::numeric_limits<float>::infinity(), rays);
    }
    float through[kLanes];
    pass(count, accel::RayKind::shadow, rays, through);
    for (int i = 0; i < count; ++i) arrives[cells[i]] = through[i];
  });
  return arrives;
}

}  // namespace gluray::render

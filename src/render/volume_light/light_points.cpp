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
constexpr float kUnitDepth = 2.7182818f;  // 1 / the share that passes an optical depth of 1

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
                         const std::vector<PlacedLattice>& media)
    : frame_(frame),
      metric_(metric),
      occluders_(occluders),
      media_(media),
      lattice_(*media.front().extinction),
      worldFromLattice_(glm::inverse(media.front().latticeFromWorld)),
      cells_(litCells(lattice_)) {}

glm::ivec3 LightPoints::cellOf(uint32_t cell) const {
  const glm::uvec3 size(lattice_.size);
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

void LightPoints::pass(int count, accel::RayKind kind, accel::OcclusionRays& rays, Shares& shares) const {
  alignas(64) int32_t valid[kLanes];
  for (int i = 0; i < kLanes; ++i) valid[i] = i < count ? -1 : 0;
  const Transmittance light(occluders_);
  const uint32_t blocked = occludedHere(frame_, valid, rays, kind, occluders_.areSolid() ? nullptr : &light,
                                        {.grey = light.through});
  for (int i = 0; i < count; ++i) {
    shares.bySurfaces[i] = blocked >> i & 1 ? 0 : light.through[i];
    shares.byMedia[i] = 0;
    if (shares.bySurfaces[i] > 0)
      shares.byMedia[i] = transmittanceOf(media_, {rays.orgX[i], rays.orgY[i], rays.orgZ[i]},
                                          {rays.dirX[i], rays.dirY[i], rays.dirZ[i]}, rays.tFar[i]);
  }
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
  std::vector<float> open(lattice_.values.size(), 1.0f);
  eachGroup([&](const uint32_t* cells, int count) {
    accel::OcclusionRays rays;
    std::array<float, kDirections> shares[kLanes];
    for (int k = 0; k < kDirections; ++k) {
      for (int i = 0; i < count; ++i)
        aim(i, pointOf(cells[i]), direction(k, kDirections, shiftOf(cells[i])), radius, rays);
      Shares passing;
      pass(count, accel::RayKind::occlusion, rays, passing);
      for (int i = 0; i < count; ++i)
        shares[i][static_cast<size_t>(k)] = passing.bySurfaces[i] * passing.byMedia[i];
    }
    for (int i = 0; i < count; ++i) open[cells[i]] = opennessOf(shares[i]);
  });
  return smoothed(open);
}

/// Of neighbouring cells, which share what is noise.
std::vector<float> LightPoints::smoothed(const std::vector<float>& values) const {
  std::vector<float> means = values;
  tbb::parallel_for(size_t{0}, cells_.size(), [&](size_t i) {
    const glm::ivec3 cell = cellOf(cells_[i]), first = glm::max(cell - 1, 0),
                     last = glm::min(cell + 1, lattice_.size - 1);
    float sum = 0;
    int count = 0;
    for (int z = first.z; z <= last.z; ++z)
      for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x, ++count) sum += values[lattice_.index({x, y, z})];
    means[cells_[i]] = sum / static_cast<float>(count);
  });
  return means;
}

std::vector<float> LightPoints::arriving(const Source& source) const {
  std::vector<float> arrives(lattice_.values.size(), 1.0f);
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
    Shares passing;
    pass(count, accel::RayKind::shadow, rays, passing);
    for (int i = 0; i < count; ++i)
      arrives[cells[i]] = passing.bySurfaces[i] * std::min(1.0f, kUnitDepth * passing.byMedia[i]);
  });
  return arrives;
}

}  // namespace gluray::render

#include "render/volume_light/medium.h"

#include "render/volumes/volume_kernels.h"
#include "render/volumes/volume_tables.h"
#include "scene/secondary_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gluray::render {

glm::ivec3 latticeSizeOf(const glm::ivec3& voxels) {
  constexpr int64_t kMost = int64_t{1} << 18;
  const auto sizeFor = [&](int side) { return glm::max((voxels + side - 1) / side, 1); };
  int side = 1;
  const auto cells = [&] {
    const glm::ivec3 size = sizeFor(side);
    return int64_t{size.x} * size.y * size.z;
  };
  while (cells() > kMost) ++side;
  return sizeFor(side);
}

namespace {

/// Where a sample of a lattice lies in texture space: the `part`-th of `parts` in each cell along an axis.
glm::vec3 firstOf(const scene::Medium& medium, const glm::vec3& cell, const glm::vec3& share, int y, int z) {
  return medium.lower + cell * (share + glm::vec3(0, y, z));
}

bool isClipped(const scene::VolumeClipping& clipping, const glm::vec3& texture) {
  const glm::dvec4 p = clipping.spaceFromTexture * glm::dvec4(texture, 1);
  return std::any_of(clipping.planes.begin(), clipping.planes.end(),
                     [&](const glm::dvec4& plane) { return glm::dot(plane, p) < 0; });
}

float extinction(float opacity, float step) {
  constexpr float kMostOpaque = 0.999f;
  return -std::log1p(-std::min(opacity, kMostOpaque)) / step;
}

}  // namespace

std::shared_ptr<const Lattice> extinctionOf(const scene::Medium& medium) {
  const scene::Volume& volume = medium.volume;
  if (volume.blend != scene::VolumeBlend::composite || whyUntraceable(volume)) return nullptr;
  scene::Volume unlit = volume;
  unlit.shading.model = scene::VolumeShading::Model::none;
  VolumeFrame frame;
  frame.volume = &unlit;
  addLookups(frame);
  auto lattice = std::make_shared<Lattice>();
  const glm::ivec3 size = lattice->size = latticeSizeOf(volume.grid->size);
  lattice->values.resize(lattice->index({0, 0, size.z}));
  const glm::vec3 cell = (medium.upper - medium.lower) / glm::vec3(size);
  // Along axes where a cell has several voxels, two samples a cell.
  const glm::ivec3 parts = glm::clamp(volume.grid->size / size, 1, 2);
  const float share = 1.0f / static_cast<float>(parts.x * parts.y * parts.z), step = medium.step;
  tbb::parallel_for(0, size.z, [&](int z) {
    std::vector<float> opacities(static_cast<size_t>(size.x));
    for (int y = 0; y < size.y; ++y) {
      float* const row = &lattice->values[lattice->index({0, y, z})];
      for (int part = 0; part < parts.x * parts.y * parts.z; ++part) {
        const glm::vec3 at(part % parts.x, part / parts.x % parts.y, part / (parts.x * parts.y));
        const glm::vec3 first = firstOf(medium, cell, (at + 0.5f) / glm::vec3(parts), y, z);
        sampleRow(frame, first, cell.x, size.x, opacities.data());
        for (int x = 0; x < size.x; ++x) {
          const glm::vec3 p = first + glm::vec3(cell.x * static_cast<float>(x), 0, 0);
          const float opacity = opacities[static_cast<size_t>(x)];
          if (opacity > 0 && !(medium.clipping && isClipped(*medium.clipping, p)))
            row[x] += share * extinction(opacity, step);
        }
      }
    }
  });
  double sum = 0;
  for (const float value : lattice->values) sum += value;
  lattice->mean = static_cast<float>(sum / static_cast<double>(lattice->values.size()));
  return lattice;
}

std::shared_ptr<const Lattice> Media::extinctionOf(const scene::PlacedVolume& volume, Arena& arena) {
  std::erase_if(known_, [](const Known& k) { return k.grid.expired(); });
  const scene::Medium& medium = *volume.medium;
  const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& known) {
    if (known.grid.lock() != medium.volume.grid) return false;
    scene::Medium compared = known.medium;
    compared.volume.grid = medium.volume.grid;
    return scene::blockAlike(compared, medium);
  });
  if (found != known_.end()) {
    std::rotate(found, found + 1, known_.end());
    return known_.back().extinction;
  }
  constexpr size_t kMost = 8;
  if (known_.size() >= kMost) known_.erase(known_.begin());
  Known made{medium.volume.grid, medium, arena.execute([&] { return render::extinctionOf(medium); })};
  made.medium.volume.grid.reset();
  return known_.emplace_back(std::move(made)).extinction;
}

PlacedLattice Media::placed(const scene::PlacedVolume& volume, const glm::dmat4& eyeFromWorld, Arena& arena) {
  PlacedLattice placed;
  placed.extinction = extinctionOf(volume, arena);
  if (!placed.extinction) return placed;
  const scene::Medium& medium = *volume.medium;
  const glm::dmat4 dataFromWorld = glm::inverse(volume.eyeFromData) * eyeFromWorld;
  const glm::dvec3 cells = glm::dvec3(placed.extinction->size) / glm::dvec3(medium.upper - medium.lower);
  const glm::dmat4 latticeFromTexture =
      glm::scale(glm::dmat4(1), cells) * glm::translate(glm::dmat4(1), -glm::dvec3(medium.lower));
  placed.latticeFromWorld = glm::mat4(latticeFromTexture * medium.textureFromData * dataFromWorld);
  placed.dataFromWorld = glm::mat3(dataFromWorld);
  return placed;
}

std::vector<PlacedLattice> Media::of(const scene::Snapshot& snapshot, Arena& arena) {
  std::vector<PlacedLattice> all;
  if (!snapshot.secondaryScene) return all;
  for (const scene::PlacedVolume& volume : snapshot.secondaryScene->volumes) {
    PlacedLattice one = placed(volume, snapshot.eyeFromWorld, arena);
    if (one.extinction) all.push_back(std::move(one));
  }
  return all;
}

size_t Media::bytes() const {
  size_t sum = 0;
  for (const Known& known : known_)
    if (known.extinction) sum += known.extinction->values.capacity() * sizeof(float);
  return sum;
}

}  // namespace gluray::render

// The extinction of volumes: made once for their voxels and transfer functions, kept from frame to frame.
#pragma once
#include "parallel/arena.h"
#include "render/media/medium_lattice.h"
#include "scene/snapshot.h"
#include "scene/volumes/placed_volume.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace gluray::render {

/// Cells of a lattice over voxels, along each axis: equal numbers of voxels a cell, as few as leave at most
/// 2^18 cells.
glm::ivec3 latticeSizeOf(const glm::ivec3& voxels);

/// The mean extinction in the cells of a lattice over the medium, per unit of length in data space:
/// -ln(1 - opacity) / step of up to eight samples a cell. Inside an arena. Null: its volume cannot be traced,
/// or is blended in a way that blocks no light.
std::shared_ptr<const Lattice> extinctionOf(const scene::Medium& medium);

/// One thread at a time.
class Media {
 public:
  /// The media of a snapshot's secondary scene, in its world. Throws std::bad_alloc.
  std::vector<PlacedLattice> of(const scene::Snapshot& snapshot, Arena& arena);
  /// One medium, in a world.
  PlacedLattice placed(const scene::PlacedVolume& volume, const glm::dmat4& eyeFromWorld, Arena& arena);
  /// Memory of what is kept.
  size_t bytes() const;

 private:
  struct Known {
    std::weak_ptr<const scene::VoxelGrid> grid;
    scene::Medium medium;  // without a grid
    std::shared_ptr<const Lattice> extinction;
  };
  std::shared_ptr<const Lattice> extinctionOf(const scene::PlacedVolume& volume, Arena& arena);

  std::vector<Known> known_;  // of grids that live; the one used last is the last
};

}  // namespace gluray::render

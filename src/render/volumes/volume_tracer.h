// Traces volumes, and keeps what it knows of their voxels from frame to frame. One thread at a time.
#pragma once
#include "accel/volumes/macro_cells.h"
#include "base/image.h"
#include "parallel/arena.h"
#include "render/media/sample_illumination.h"
#include "scene/volumes/volume.h"

#include <memory>
#include <vector>

namespace gluray::render {

class VolumeTracer {
 public:
  /// Sets `image` to the pixels of the view's region: premultiplied colours as floats, and the depth of the
  /// entry, or Image::kMiss where nothing is shown. False, with the reason in `why`, if the volume cannot be
  /// traced. Throws std::bad_alloc.
  /// `arriving`: of volumes that are blended as VolumeBlend::composite; null: the light of the volume's own
  /// shading, all of it.
  bool trace(const scene::VolumeCast& cast, Arena& arena, Image& image, const char*& why,
             const SampleIllumination* arriving = nullptr);
  /// Memory of what is kept.
  size_t bytes() const;

 private:
  /// What is known of a grid, and of it with the last transfer functions.
  struct Known {
    std::weak_ptr<const scene::VoxelGrid> grid;
    std::vector<accel::MacroCells> cells;  // of each channel
    std::vector<uint8_t> empty;            // emptySpace() of:
    scene::VolumeChannels use{};
    std::vector<scene::VolumeChannel> channels;
    std::shared_ptr<const scene::VolumeTable2D> table;
    bool isEmptyOf(const scene::Volume& volume) const;
  };
  Known& knownOf(const scene::Volume& volume);

  std::vector<Known> known_;  // of grids that live
};

}  // namespace gluray::render

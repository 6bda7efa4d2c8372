#include "render/volumes/volume_tables.h"

namespace gluray::render {
namespace {

/// Whether a table that samples are looked up in is missing.
bool lacksTables(const scene::Volume& volume) {
  const bool grey =
      volume.blend == scene::VolumeBlend::average || volume.blend == scene::VolumeBlend::additive;
  using Use = scene::VolumeChannels;
  if (scene::takesLevels(volume.blend)) return volume.channels.front().color.values.empty();
  if ((volume.use == Use::table || volume.use == Use::labels) &&
      (!volume.table || volume.table->values.empty()))
    return true;
  if (volume.use == Use::table) return false;
  for (size_t c = 0; c < volume.channels.size(); ++c) {
    const bool each = volume.use == Use::independent;
    const bool colored = !grey && (each || (c == 0 && volume.use != Use::colors));
    if (colored && volume.channels[c].color.values.empty()) return true;
    if ((each || c == scene::opacityChannelOf(volume.use)) && volume.channels[c].opacity.values.empty())
      return true;
  }
  return false;
}

}  // namespace

const char* whyUntraceable(const scene::Volume& volume) {
  constexpr size_t kMostVoxels = size_t{1} << 31;
  for (const scene::VoxelGrid* const grid :
       {volume.grid.get(), volume.mask.get(), volume.labels.voxels.get()})
    if (grid && grid->voxels() > kMostVoxels) return "it has more than 2^31 voxels";
  if (static_cast<size_t>(volume.grid->channels) < volume.channels.size())
    return "its voxels have fewer channels than it uses";
  return lacksTables(volume) ? "it has no transfer function" : nullptr;
}

}  // namespace gluray::render

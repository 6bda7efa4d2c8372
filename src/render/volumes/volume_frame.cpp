#include "render/volumes/volume_frame.h"

#include <utility>

namespace gluray::render {
namespace {

/// `channel`: where the table's numbers go.
VolumeLookup lookupOf(const scene::VolumeTable& table, int channel) {
  VolumeLookup lookup;
  lookup.count = static_cast<float>(table.entries()), lookup.linear = table.linear;
  for (int i = 0; i < table.entries(); ++i) {
    glm::vec4 entry(0);
    for (int c = 0; c < table.channels; ++c)
      entry[channel + c] = table.values[static_cast<size_t>(i * table.channels + c)];
    lookup.entries.push_back(entry);
  }
  if (!lookup.entries.empty()) lookup.entries.push_back(lookup.entries.back());
  return lookup;
}

VolumeLookup2D lookupOf(const scene::VolumeTable2D& table) {
  VolumeLookup2D lookup;
  lookup.size = table.size, lookup.linear = table.linear;
  for (int y = 0; y <= table.size.y; ++y)
    for (int x = 0; x <= table.size.x; ++x) {
      const glm::ivec2 entry = glm::min(glm::ivec2(x, y), table.size - 1);
      lookup.entries.push_back(table.values[static_cast<size_t>(entry.y * table.size.x + entry.x)]);
    }
  return lookup;
}

ChannelLookups lookupsOf(const scene::VolumeChannel& channel, scene::VoxelGrid::Type type) {
  ChannelLookups lookups;
  lookups.scale = channel.scale / scene::divisorOf(type), lookups.bias = channel.bias;
  lookups.color = lookupOf(channel.color, 0);
  VolumeLookup opacity = lookupOf(channel.opacity, 3);
  const bool alike =
      opacity.entries.size() == lookups.color.entries.size() && opacity.linear == lookups.color.linear;
  for (size_t i = 0; alike && i < opacity.entries.size(); ++i)
    lookups.color.entries[i].a = opacity.entries[i].a;
  if (!alike) lookups.opacity = std::move(opacity);
  if (channel.gradientOpacity) lookups.gradient = lookupOf(*channel.gradientOpacity, 3);
  return lookups;
}

}  // namespace

void addLookups(VolumeFrame& frame) {
  const scene::Volume& volume = *frame.volume;
  for (const scene::VolumeChannel& channel : volume.channels)
    frame.channels.push_back(lookupsOf(channel, volume.grid->type));
  if (volume.table) frame.table = lookupOf(*volume.table);
}

}  // namespace gluray::render

#include "render/volumes/volume_tracer.h"

#include "render/tiles/tiles.h"
#include "render/volumes/visible_cells.h"
#include "render/volumes/volume_kernels.h"

#include <algorithm>

namespace gluray::render {
namespace {

/// `channels`: where the table's numbers go.
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

/// Whether a table that samples are looked up in is missing.
bool lacksTables(const scene::Volume& volume) {
  const bool grey =
      volume.blend == scene::VolumeBlend::average || volume.blend == scene::VolumeBlend::additive;
  using Use = scene::VolumeChannels;
  if (takesLevels(volume.blend)) return volume.channels.front().color.values.empty();
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

/// Whether samples that the opacity table makes invisible change nothing.
bool mayLeap(const scene::Volume& volume) {
  return volume.blend == scene::VolumeBlend::composite || volume.blend == scene::VolumeBlend::additive;
}

}  // namespace

bool VolumeTracer::Known::isEmptyOf(const scene::Volume& volume) const {
  const auto same = [](const scene::VolumeChannel& a, const scene::VolumeChannel& b) {
    return a.scale == b.scale && a.bias == b.bias && a.opacity == b.opacity;
  };
  const auto sameTable = [&] {
    return table == volume.table || (table && volume.table && *table == *volume.table);
  };
  return !empty.empty() && use == volume.use && sameTable() &&
         std::equal(channels.begin(), channels.end(), volume.channels.begin(), volume.channels.end(), same);
}

VolumeTracer::Known& VolumeTracer::knownOf(const scene::Volume& volume) {
  std::erase_if(known_, [](const Known& k) { return k.grid.expired(); });
  const auto found = std::find_if(known_.begin(), known_.end(),
                                  [&](const Known& k) { return k.grid.lock() == volume.grid; });
  if (found != known_.end()) return *found;
  Known known;
  known.grid = volume.grid;
  for (int c = 0; c < volume.grid->channels; ++c) known.cells.emplace_back(*volume.grid, c);
  return known_.emplace_back(std::move(known));
}

bool VolumeTracer::trace(const scene::VolumeCast& cast, Arena& arena, Image& image, const char*& why) {
  const scene::Volume& volume = cast.volume;
  const scene::Region& region = cast.view.region;
  constexpr size_t kMostVoxels = size_t{1} << 31;
  for (const scene::VoxelGrid* const grid :
       {volume.grid.get(), volume.mask.get(), volume.labels.voxels.get()})
    if (grid && grid->voxels() > kMostVoxels) return why = "it has more than 2^31 voxels", false;
  if (static_cast<size_t>(volume.grid->channels) < volume.channels.size())
    return why = "its voxels have fewer channels than it uses", false;
  if (lacksTables(volume)) return why = "it has no transfer function", false;
  return arena.execute([&] {
    Known& known = knownOf(volume);
    const auto finite = [](const accel::MacroCells& cells) { return cells.finite(); };
    if (!std::all_of(known.cells.begin(), known.cells.end(), finite))
      return why = "it has values that are no numbers", false;
    const bool leaps = mayLeap(volume);
    if (leaps && !known.isEmptyOf(volume)) {
      known.empty = emptySpace(known.cells, volume);
      known.use = volume.use, known.channels = volume.channels, known.table = volume.table;
    }
    const VolumeRays rays(cast.view);
    VolumeFrame frame;
    frame.volume = &volume, frame.rays = &rays, frame.image = &image;
    frame.cells = known.cells.front().size(), frame.empty = leaps ? &known.empty : nullptr;
    for (const scene::VolumeChannel& channel : volume.channels)
      frame.channels.push_back(lookupsOf(channel, volume.grid->type));
    if (volume.table) frame.table = lookupOf(*volume.table);
    frame.showsInvisible = cast.view.replaces;
    image.resize(region.width, region.height, 1, Image::kWide);
    image.x = region.x, image.y = region.y, image.missColor = 0;
    eachTile(Tiles(image, kTileSize), "volume", {}, [&](const Tile& tile) { castTile(frame, tile); });
    return true;
  });
}

size_t VolumeTracer::bytes() const {
  size_t sum = 0;
  for (const Known& known : known_) {
    for (const accel::MacroCells& cells : known.cells) sum += cells.bytes();
    sum += known.empty.capacity();
  }
  return sum;
}

}  // namespace gluray::render

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

void addTables(const scene::Volume& volume, VolumeFrame& frame) {
  frame.color = lookupOf(volume.color, 0);
  VolumeLookup opacity = lookupOf(volume.opacity, 3);
  const bool alike =
      opacity.entries.size() == frame.color.entries.size() && opacity.linear == frame.color.linear;
  for (size_t i = 0; alike && i < opacity.entries.size(); ++i)
    frame.color.entries[i].a = opacity.entries[i].a;
  if (!alike) frame.opacity = std::move(opacity);
  if (volume.gradientOpacity) frame.gradient = lookupOf(*volume.gradientOpacity, 3);
}

/// Whether samples that the opacity table makes invisible change nothing.
bool mayLeap(const scene::Volume& volume) { return volume.blend == scene::VolumeBlend::composite; }

}  // namespace

VolumeTracer::Known& VolumeTracer::knownOf(const scene::Volume& volume) {
  std::erase_if(known_, [](const Known& k) { return k.grid.expired(); });
  const auto found = std::find_if(known_.begin(), known_.end(),
                                  [&](const Known& k) { return k.grid.lock() == volume.grid; });
  if (found != known_.end()) return *found;
  Known known;
  known.grid = volume.grid;
  known.cells = std::make_shared<accel::MacroCells>(*volume.grid, 0);
  return known_.emplace_back(std::move(known));
}

bool VolumeTracer::trace(const scene::VolumeCast& cast, Arena& arena, Image& image, const char*& why) {
  const scene::Volume& volume = cast.volume;
  const scene::Region& region = cast.view.region;
  if (volume.grid->voxels() > size_t{1} << 31) return why = "it has more than 2^31 voxels", false;
  return arena.execute([&] {
    Known& known = knownOf(volume);
    if (!known.cells->finite()) return why = "it has values that are no numbers", false;
    const bool leaps = mayLeap(volume);
    if (leaps && (known.empty.empty() || !(known.opacity == volume.opacity) || known.scale != volume.scale ||
                  known.bias != volume.bias)) {
      known.empty = emptySpace(*known.cells, volume);
      known.opacity = volume.opacity, known.scale = volume.scale, known.bias = volume.bias;
    }
    const VolumeRays rays(cast.view);
    VolumeFrame frame;
    frame.volume = &volume, frame.rays = &rays, frame.image = &image;
    frame.cells = known.cells->size(), frame.empty = leaps ? &known.empty : nullptr;
    addTables(volume, frame);
    const bool grey =
        volume.blend == scene::VolumeBlend::average || volume.blend == scene::VolumeBlend::additive;
    if ((frame.color.entries.empty() && !grey) || volume.opacity.values.empty())
      return why = "it has no transfer function", false;
    image.resize(region.width, region.height, 1, Image::kWide);
    image.x = region.x, image.y = region.y, image.missColor = 0;
    eachTile(Tiles(image, kTileSize), "volume", {}, [&](const Tile& tile) { castTile(frame, tile); });
    return true;
  });
}

size_t VolumeTracer::bytes() const {
  size_t sum = 0;
  for (const Known& known : known_) sum += known.cells->bytes() + known.empty.capacity();
  return sum;
}

}  // namespace gluray::render

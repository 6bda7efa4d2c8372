#include "render/volumes/volume_tracer.h"

#include "render/tiles/tiles.h"
#include "render/volumes/visible_cells.h"
#include "render/volumes/volume_kernels.h"
#include "render/volumes/volume_tables.h"

#include <algorithm>

namespace gluray::render {
namespace {

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

bool VolumeTracer::trace(const scene::VolumeCast& cast, Arena& arena, Image& image, const char*& why,
                         const SampleIllumination* arriving) {
  const scene::Volume& volume = cast.volume;
  const scene::Region& region = cast.view.region;
  if (const char* found = whyUntraceable(volume)) return why = found, false;
  return arena.execute([&] {
    Known& known = knownOf(volume);
    const auto finite = [](const accel::MacroCells& cells) { return cells.finite(); };
    if (!std::all_of(known.cells.begin(), known.cells.end(), finite))
      return why = "it has values that are no numbers", false;
    const bool leaps = mayLeap(volume);
    if (leaps && !known.isEmptyOf(volume)) {
      known.empty = emptySpace(known.cells, volume);
      known.empty.resize(known.empty.size() + VolumeFrame::kEmptyPadding);
      known.use = volume.use, known.channels = volume.channels, known.table = volume.table;
    }
    const VolumeRays rays(cast.view);
    VolumeFrame frame;
    frame.volume = &volume, frame.rays = &rays, frame.image = &image;
    frame.cells = known.cells.front().size(), frame.empty = leaps ? &known.empty : nullptr;
    addLookups(frame);
    frame.arriving = arriving;
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

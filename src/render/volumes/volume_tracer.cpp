#include "render/volumes/volume_tracer.h"

#include "render/tiles/tiles.h"
#include "render/volumes/visible_cells.h"
#include "render/volumes/volume_kernels.h"
#include "render/volumes/volume_tables.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace gluray::render {
namespace {

/// Whether samples that the opacity table makes invisible change nothing.
bool mayLeap(const scene::Volume& volume) {
  return volume.blend == scene::VolumeBlend::composite || volume.blend == scene::VolumeBlend::additive;
}

/// Calls body(index of the pixel) for a tile's pixels.
template <class Body>
void eachPixel(const Tile& tile, const Image& image, const Body& body) {
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x)
      body(static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x));
}

/// Sum of the luminances of a tile's pixels, which are premultiplied.
double luminanceOf(const Tile& tile, const Image& image) {
  double sum = 0;
  eachPixel(tile, image, [&](size_t pixel) {
    const float* const c = &image.wideColor[4 * pixel];
    if (image.depth[pixel] != Image::kMiss) sum += 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
  });
  return sum;
}

/// The factor that makes the frame's image as bright as without the illumination of the settings, by some of
/// its tiles. Uses the frame's image.
float exposureOf(VolumeFrame& frame) {
  constexpr int kEach = 9;  // one tile of so many
  const Tiles tiles(*frame.image, kTileSize);
  const SampleIllumination* const arriving = frame.arriving;
  const auto brightness = [&](const SampleIllumination* light) {
    frame.arriving = light;
    std::vector<double> sums(static_cast<size_t>(tiles.columns * tiles.rows / kEach + 1), 0.0);
    tbb::parallel_for(size_t{0}, sums.size(), [&](size_t i) {
      const FloatGuard guard;
      const int index = std::min(static_cast<int>(i) * kEach + kEach / 2, tiles.columns * tiles.rows - 1);
      const Tile tile = tiles.at(index);
      castTile(frame, tile);
      sums[i] = luminanceOf(tile, *frame.image);
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
  };
  const double own = brightness(nullptr), lit = brightness(arriving);
  constexpr double kMost = 8;
  if (!(own > 0)) return 1;
  return static_cast<float>(lit > 0 ? std::clamp(own / lit, 1 / kMost, kMost) : kMost);
}

/// Brightens a tile's pixels; no channel exceeds the opacity, and hues stay.
void expose(const Tile& tile, float factor, Image& image) {
  eachPixel(tile, image, [&](size_t pixel) {
    float* const c = &image.wideColor[4 * pixel];
    const float most = std::max({c[0], c[1], c[2]});
    const float by = most * factor > c[3] && most > 0 ? std::max(1.0f, c[3] / most) : factor;
    for (int i = 0; i < 3; ++i) c[i] *= by;
  });
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
    const float exposure = arriving && arriving->keepsBrightness ? exposureOf(frame) : 1;
    eachTile(Tiles(image, kTileSize), "volume", {}, [&](const Tile& tile) {
      castTile(frame, tile);
      if (exposure != 1) expose(tile, exposure, image);
    });
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

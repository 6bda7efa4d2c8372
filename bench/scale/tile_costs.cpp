#include "bench/scale/tile_costs.h"

#include "bench/data/report.h"
#include "bench/scale/cpu_seconds.h"
#include "cluster/messages/rank_messages.h"
#include "render/tiles/tile_source.h"
#include "render/tiles/tiles.h"

#include <stdexcept>

namespace gluray::bench {
namespace {

/// Hands out all tiles to one thread and times them.
class TimedTiles final : public render::TileSource {
 public:
  void begin(const Image& image) noexcept override {
    image_ = &image;
    const render::Tiles tiles(image, render::kTileSize);
    seconds.assign(static_cast<size_t>(tiles.columns * tiles.rows), 0);
    next_ = 0;
  }
  int nextTile() noexcept override {
    started_ = threadCpuSeconds();
    if (next_ == 0) first = started_;
    if (static_cast<size_t>(next_) < seconds.size()) return next_++;
    last = started_;
    return -1;
  }
  void done(int tile, double, bool) noexcept override {
    const double traced = threadCpuSeconds();
    seconds[static_cast<size_t>(tile)] = traced - started_;
    cluster::TracedTile message{1, cluster::shapeOf(*image_), tile, 0, false, {}};
    message.pixels = cluster::packTile(*image_, render::Tiles(*image_, render::kTileSize).at(tile));
    const std::vector<std::byte> bytes = cluster::forRanks(message);
    pack += bytes.empty() ? 0 : threadCpuSeconds() - traced;
  }

  std::vector<double> seconds;
  double first = 0, last = 0, pack = 0;

 private:
  const Image* image_ = nullptr;
  int next_ = 0;
  double started_ = 0;
};

}  // namespace

TileCosts tileCosts(frame::Renderer& renderer, scene::Snapshot snapshot, int rounds, Image& image) {
  snapshot.settings.threads = 1;
  const double clock = threadCpuClockSeconds();
  std::vector<std::vector<double>> ofTile;
  std::vector<double> begins, ends, packs;
  for (int round = -1; round < rounds; ++round) {
    TimedTiles tiles;
    scene::TraceCost cost;
    std::string error;
    const double start = threadCpuSeconds();
    if (!renderer.renderTiles(snapshot, image, cost, error, tiles, false)) throw std::runtime_error(error);
    if (round < 0) continue;
    const double count = static_cast<double>(tiles.seconds.size());
    ofTile.resize(tiles.seconds.size());
    for (size_t i = 0; i < ofTile.size(); ++i) ofTile[i].push_back(tiles.seconds[i] - clock);
    begins.push_back(tiles.first - start), ends.push_back(threadCpuSeconds() - tiles.last);
    packs.push_back(tiles.pack / count - clock);
  }
  TileCosts costs;
  for (const std::vector<double>& seconds : ofTile) costs.tiles.push_back(median(seconds));
  costs.pack = median(packs), costs.begin = median(begins), costs.end = median(ends);
  return costs;
}

}  // namespace gluray::bench

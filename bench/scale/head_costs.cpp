#include "bench/scale/head_costs.h"

#include "bench/scale/cpu_seconds.h"
#include "cluster/worker/requested_image.h"
#include "render/tiles/tiles.h"

#include <algorithm>
#include <deque>

namespace gluray::bench {
namespace {

/// As Head::giveTiles: what the rank gets goes into its queue.
void give(cluster::RequestedImage& requested, int rank, std::deque<int>& queue) {
  if (!requested.takesPart(rank)) return;
  const std::vector<int> tiles = requested.more(rank);
  if (tiles.empty()) return;
  cluster::forRanks(cluster::MoreTiles{requested.id(), tiles});
  queue.insert(queue.end(), tiles.begin(), tiles.end());
}

/// The CPU time of one image, all tiles together.
HeadCosts spentOn(cluster::RequestedImage& requested, const std::vector<std::vector<std::byte>>& messages,
                  int ranks, cluster::WrittenMemory& memory) {
  std::vector<std::deque<int>> queues(static_cast<size_t>(ranks));
  HeadCosts sum;
  for (size_t rank = 0; rank < queues.size(); ++rank) give(requested, static_cast<int>(rank), queues[rank]);
  while (!requested.isTraced())
    for (size_t rank = 0; rank < queues.size(); ++rank) {
      if (queues[rank].empty()) continue;
      const auto& bytes = messages[static_cast<size_t>(queues[rank].front())];
      queues[rank].pop_front();
      const double start = threadCpuSeconds();
      cluster::ByteReader in(bytes);
      in.get<uint16_t>();
      bool grew = false;
      const auto tile = cluster::decoded<cluster::TracedTile>(in.readBytes(in.left()));
      requested.addTile(static_cast<int>(rank), tile, memory, grew, 0);
      const double taken = threadCpuSeconds();
      if (!requested.isTraced()) give(requested, static_cast<int>(rank), queues[rank]);
      sum.take += taken - start, sum.give += threadCpuSeconds() - taken;
    }
  return sum;
}

}  // namespace

HeadCosts headCosts(const Image& image, const std::vector<float>& costs, int ranks, int threads) {
  cluster::TraceRequest request;
  request.width = image.width, request.height = image.height;
  const render::Tiles tiles(image, render::kTileSize);
  std::vector<std::vector<std::byte>> messages;
  for (int tile = 0; tile < tiles.columns * tiles.rows; ++tile)
    messages.push_back(cluster::forRanks(cluster::TracedTile{1, cluster::shapeOf(image), tile, 1e-3f, false,
                                                             cluster::packTile(image, tiles.at(tile))}));
  const cluster::RankStates states(ranks, 0, threads);
  cluster::WrittenMemory memory;  // new for the first image, as in a program
  HeadCosts sum;
  for (int round = 0; round < 2; ++round) {
    cluster::RequestedImage requested(request, 1, false, states, costs, cluster::RequestedImage::Kind::shared,
                                      0);
    sum = spentOn(requested, messages, ranks, memory);
  }
  const auto count = static_cast<double>(messages.size());
  const double clock = threadCpuClockSeconds();
  return {sum.take / count - clock, std::max(sum.give / count - clock, 0.0)};
}

}  // namespace gluray::bench

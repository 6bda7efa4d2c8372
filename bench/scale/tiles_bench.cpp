// gluray-bench-tiles: what an image of the Wavelet costs the ranks of a job and its head, tile by tile, and
// the sizes of their messages: what the simulation of many ranks needs to know. One object of JSON.
#include "bench/scale/head_costs.h"
#include "bench/scale/tile_costs.h"
#include "bench/scale/views.h"
#include "cluster/messages/program_messages.h"
#include "cluster/messages/rank_messages.h"
#include "cluster/stream/snapshot_encoder.h"
#include "render/tiles/tiles.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <exception>

namespace {

using namespace gluray;

struct Options {
  double millions = 1;
  int rounds = 7, samples = 0, threads = 8;
};

nlohmann::ordered_json microsecondsOf(const std::vector<double>& seconds) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const double s : seconds) all.push_back(std::round(s * 1e7) / 10);
  return all;
}

/// Bytes of the messages of a frame.
nlohmann::ordered_json bytesOf(const scene::Snapshot& snapshot, const Image& image) {
  const cluster::EncodedSnapshot encoded = cluster::SnapshotEncoder().encode(snapshot);
  double arrays = 0;
  for (const cluster::ArraySource& array : encoded.arrays) arrays += static_cast<double>(array.bytes());
  cluster::TraceRequest request;
  request.snapshot = encoded.message;
  cluster::TraceOrder order;
  order.snapshot = encoded.message;
  const std::vector<std::byte> pixels =
      cluster::packTile(image, render::Tiles(image, render::kTileSize).at(0));
  const auto size = [](const auto& message) { return cluster::forRanks(message).size(); };
  return {{"arrays", arrays},
          {"request", cluster::encoded(request).size()},
          {"order", size(order)},
          {"tile", size(cluster::TracedTile{1, cluster::shapeOf(image), 0, 0, false, pixels})},
          {"more", size(cluster::MoreTiles{})},
          {"more_per_tile", sizeof(int32_t)},
          {"end", size(cluster::EndOfImage{})},
          {"finished", size(cluster::Finished{})},
          {"alive", size(cluster::Alive{})}};
}

void run(const Options& options) {
  const bench::TriangleMesh mesh = bench::waveletMesh(options.millions);
  scene::Snapshot snapshot = bench::waveletSnapshot(mesh);
  frame::Renderer renderer;
  Image image;
  nlohmann::ordered_json out;
  // The costs of the frame before decide who traces what.
  bench::show(snapshot, 1, options.samples, 1);
  const bench::TileCosts before = bench::tileCosts(renderer, snapshot, options.rounds, image);
  bench::show(snapshot, 2, options.samples, 1);
  const bench::TileCosts costs = bench::tileCosts(renderer, snapshot, options.rounds, image);
  out["before_us"] = microsecondsOf(before.tiles), out["tiles_us"] = microsecondsOf(costs.tiles);
  out["pack_us"] = 1e6 * costs.pack, out["begin_us"] = 1e6 * costs.begin, out["end_us"] = 1e6 * costs.end;
  const std::vector<float> known(before.tiles.begin(), before.tiles.end());
  for (int ranks = 1; ranks <= 1024; ranks *= 2) {
    const bench::HeadCosts head = bench::headCosts(image, known, ranks, options.threads);
    out["head"].push_back({{"ranks", ranks}, {"take_us", 1e6 * head.take}, {"give_us", 1e6 * head.give}});
  }
  out["bytes"] = bytesOf(snapshot, image);
  std::printf("%s\n", out.dump().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("CPU time of the tiles of an image, and of the head of a job");
  Options options;
  app.add_option("--triangles", options.millions, "million triangles")->check(CLI::Range(0.1, 256.0));
  app.add_option("--rounds", options.rounds, "tracings of each image")->check(CLI::Range(1, 1000));
  app.add_option("--samples", options.samples, "rays of ambient occlusion a pixel; 0: none")
      ->check(CLI::Range(0, 1024));
  app.add_option("--threads", options.threads, "of each rank that the head serves")
      ->check(CLI::Range(1, 1024));
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gluray-bench-tiles: %s\n", error.what());
    return 1;
  }
}

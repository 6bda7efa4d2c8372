// Messages between the ranks of a job of workers. A program's head is the rank that the program is connected
// to. Any thread.
#pragma once
#include "cluster/messages/codec.h"
#include "cluster/stream/visibility_bytes.h"

namespace gluray::cluster {

/// First message, to rank 0. Its number and members never change, so that all versions understand it.
struct RankHello {
  static constexpr uint16_t kType = 0x4848;  // in both byte orders
  static constexpr uint32_t kOrder = 0x01020304;
  uint32_t order = kOrder;  // shows the sender's byte order
  std::string version;      // of GLuRay
  std::string host;
};
/// From rank 0 to all: programs may come.
struct AllAreAlike {
  static constexpr uint16_t kType = 10;
};
/// To a head: all its broadcasts so far have arrived.
struct CaughtUp {
  static constexpr uint16_t kType = 12;
};
/// From a worker's intake to the rank itself: the array has been compared with its name.
struct ArrayChecked {
  static constexpr uint16_t kType = 11;
  uint64_t number = 0;  // of the check
  Hash128 name;
  bool isRight = false;
};
/// To rank 0, which orders the broadcasts of the job: the sender requests a broadcast of an array.
struct TurnWanted {
  static constexpr uint16_t kType = 1;
  Hash128 name;
  uint64_t bytes = 0;
};
/// From rank 0 to all: the next broadcast.
struct Turn {
  static constexpr uint16_t kType = 2;
  int32_t root = 0;
  Hash128 name;
  uint64_t bytes = 0;
};
/// From a head to all: snapshots of its programs no longer use these arrays.
struct Forget {
  static constexpr uint16_t kType = 3;
  std::vector<Hash128> names;
};
/// Parameters of a frame of an animation, whose light is filtered across tiles and ranks.
struct MovingOrder {
  bool isMoving = false;    // otherwise the other members are unused
  uint32_t index = 0;       // render::MovingTileSource::index
  int32_t raysOfPixel = 1;  // render::MovingRays
  bool quarter = false;
};
/// From a head: request to trace a share of an image.
struct TraceOrder {
  static constexpr uint16_t kType = 4;
  uint64_t id = 0;          // of the head's images
  bool shared = true;       // false: the head traces it alone
  bool averages = true;     // frame::Renderer::renderTiles
  bool meetsPeers = false;  // TraceRequest::meetsPeers
  MovingOrder moving;
  uint32_t missColor = 0;
  std::vector<Hash128> needs;  // arrays that may still be on their way
  std::vector<std::byte> snapshot;
  std::vector<std::vector<std::byte>> parts;  // snapshots of other ranks that belong to it
};
/// From a head: tiles to trace.
struct MoreTiles {
  static constexpr uint16_t kType = 5;
  uint64_t id = 0;
  std::vector<int32_t> tiles;
};
/// From a head: stop tracing this image.
struct EndOfImage {
  static constexpr uint16_t kType = 6;
  uint64_t id = 0;
};
/// To a head: a traced tile.
struct TracedTile {
  static constexpr uint16_t kType = 7;
  uint64_t id = 0;
  ImageShape shape;
  int32_t tile = 0;
  float seconds = 0;
  bool seenThrough = false;  // render::TileSource::done
  std::vector<std::byte> pixels;
};
/// To a head: a tile of a moving frame has been collected (render::MovingTileSource).
struct CollectedTile {
  static constexpr uint16_t kType = 16;
  uint64_t id = 0;
  VisibilityShape shape;
  int32_t tile = 0;
  float seconds = 0;
  std::vector<std::byte> visibility;  // packVisibility()
};
/// From a head: all tiles of the image have been collected.
struct VisibilityReady {
  static constexpr uint16_t kType = 17;
  uint64_t id = 0;
  std::vector<int32_t> tiles;         // that the rank is to colour
  Hash128 name;                       // of the array that holds the visibility
  std::vector<std::byte> visibility;  // if it is not broadcast
};
/// To a head, after the end of the image, or earlier if it cannot be traced.
struct Finished {
  static constexpr uint16_t kType = 8;
  uint64_t id = 0;
  bool improves = false;
  std::string error;  // empty: there was none
  LayerCounts layers;
  scene::TraceCost cost;
};
/// Sign of life to a head while one of its images is being traced.
struct Alive {
  static constexpr uint16_t kType = 9;
  int32_t threads = 1;
};

void fields(auto& archive, Like<RankHello> auto& value) {
  auto& [order, version, host] = value;
  archive(order, version, host);
}
void fields(auto&, Like<AllAreAlike> auto&) {}
void fields(auto&, Like<CaughtUp> auto&) {}
void fields(auto& archive, Like<ArrayChecked> auto& value) {
  auto& [number, name, isRight] = value;
  archive(number, name, isRight);
}
void fields(auto& archive, Like<TurnWanted> auto& value) {
  auto& [name, bytes] = value;
  archive(name, bytes);
}
void fields(auto& archive, Like<Turn> auto& value) {
  auto& [root, name, bytes] = value;
  archive(root, name, bytes);
}
void fields(auto& archive, Like<Forget> auto& value) {
  auto& [names] = value;
  archive(names);
}
void fields(auto& archive, Like<MovingOrder> auto& value) {
  auto& [isMoving, index, raysOfPixel, quarter] = value;
  archive(isMoving, index, raysOfPixel, quarter);
}
void fields(auto& archive, Like<TraceOrder> auto& value) {
  auto& [id, shared, averages, meetsPeers, moving, missColor, needs, snapshot, parts] = value;
  archive(id, shared, averages, meetsPeers, moving, missColor, needs, snapshot, parts);
}
void fields(auto& archive, Like<VisibilityShape> auto& value) {
  auto& [width, height, channels] = value;
  archive(width, height, channels);
}
void fields(auto& archive, Like<CollectedTile> auto& value) {
  auto& [id, shape, tile, seconds, visibility] = value;
  archive(id, shape, tile, seconds, visibility);
}
void fields(auto& archive, Like<VisibilityReady> auto& value) {
  auto& [id, tiles, name, visibility] = value;
  archive(id, tiles, name, visibility);
}
void fields(auto& archive, Like<MoreTiles> auto& value) {
  auto& [id, tiles] = value;
  archive(id, tiles);
}
void fields(auto& archive, Like<EndOfImage> auto& value) {
  auto& [id] = value;
  archive(id);
}
void fields(auto& archive, Like<TracedTile> auto& value) {
  auto& [id, shape, tile, seconds, seenThrough, pixels] = value;
  archive(id, shape, tile, seconds, seenThrough, pixels);
}
void fields(auto& archive, Like<Finished> auto& value) {
  auto& [id, improves, error, layers, cost] = value;
  archive(id, improves, error, layers, cost);
}
void fields(auto& archive, Like<Alive> auto& value) {
  auto& [threads] = value;
  archive(threads);
}

}  // namespace gluray::cluster

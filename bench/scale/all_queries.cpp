#include "bench/scale/all_queries.h"

#include "cluster/peers/query_stream.h"
#include "render/frame_data/frame_data.h"
#include "render/moving/moving_tile_source.h"
#include "render/remote/remote_surfaces.h"
#include "render/tiles/hidden_pixels.h"
#include "render/tiles/tiles.h"

#include <stdexcept>

namespace gluray::bench {
namespace {

/// A peer that is asked everything and blocks nothing, and the tiles of the image. One thread.
class Recorder final : public render::RemoteSurfaces, public render::MovingTileSource {
 public:
  void begin(const render::FrameData& frame) override { bounds_ = frame.world->lightBounds(); }
  void beginEmpty(const scene::Snapshot&) override {}
  accel::Bounds bounds() const noexcept override { return bounds_; }
  bool changed() const noexcept override { return false; }
  uint32_t occluded(const render::RemoteQuery& query, uint32_t blocked, render::Passing) noexcept override {
    cluster::QueryPacket packet{0, query.kind, {}, query.rays};
    for (int i = 0; i < accel::kLanes; ++i) packet.lanes |= static_cast<uint32_t>(query.valid[i] != 0) << i;
    // Lengths of blocked rays are lost: as long as the others.
    for (int i = 0; i < accel::kLanes; ++i)
      if (packet.lanes & ~blocked & 1u << i) length_ = query.rays.tFar[i];
    for (int i = 0; i < accel::kLanes; ++i)
      if (packet.lanes & blocked & 1u << i) packet.rays.tFar[i] = length_;
    if (packet.lanes) writer_.add(packet), ++all.packets;
    return blocked;
  }
  bool recall(uint32_t&) noexcept override { return false; }
  bool isReplaying() const noexcept override { return false; }
  bool hasDepths() const noexcept override { return false; }
  bool exchangeDepths(const render::Tile&, const Image&) noexcept override { return false; }
  const render::HiddenPixels& hidden(const render::Tile&, const Image&) noexcept override { return none_; }
  void hold(const std::function<void()>& whole) noexcept override { whole(); }

  void begin(const Image& image) noexcept override {
    const render::Tiles tiles(image, render::kTileSize);
    count_ = tiles.columns * tiles.rows;
  }
  int nextTile() noexcept override { return next_ < count_ ? next_++ : -1; }
  void done(int, double, bool) noexcept override {
    all.rays += writer_.rays();
    all.bytes += writer_.takeBytes().size();
    writer_ = {};
  }
  uint32_t index(uint32_t own) const noexcept override { return own; }
  void collected(const render::VisibilityBuffer&, int tile, double seconds) noexcept override {
    done(tile, seconds, false);
  }
  bool complete(render::VisibilityBuffer&) noexcept override { return true; }
  int nextToColor() noexcept override { return colored_ < count_ ? colored_++ : -1; }

  AllQueries all;

 private:
  const render::HiddenPixels none_;
  cluster::QueryWriter writer_;
  accel::Bounds bounds_;
  float length_ = 0;
  int count_ = 0, next_ = 0, colored_ = 0;
};

}  // namespace

AllQueries allQueries(frame::Renderer& renderer, scene::Snapshot snapshot) {
  snapshot.settings.threads = 1;
  Recorder recorder;
  Image image;
  scene::TraceCost cost;
  std::string error;
  if (!renderer.renderPart(snapshot, image, cost, error, recorder, false, recorder))
    throw std::runtime_error(error);
  for (const float depth : image.depth) recorder.all.pixels += depth != Image::kMiss;
  return recorder.all;
}

}  // namespace gluray::bench

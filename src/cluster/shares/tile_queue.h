// Queue of the tiles of an image that a head has assigned to this rank; sends traced tiles back. Any thread.
#pragma once
#include "cluster/messages/rank_messages.h"
#include "cluster/ranks/outbox.h"
#include "render/tiles/tile_source.h"
#include "render/tiles/tiles.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

namespace gluray::cluster {

class TileQueue final : public render::TileSource {
 public:
  /// The outbox must outlive it.
  TileQueue(int head, uint64_t id, Outbox& outbox) : head_(head), id_(id), outbox_(outbox) {}

  void add(const std::vector<int32_t>& tiles);
  /// Closes the queue; waiting threads return.
  void close();
  bool isClosed() const { return closed_.load(std::memory_order_relaxed); }

  /// For a moving frame: no more tiles follow.
  void setVisibility(VisibilityReady comes);
  /// Waits for the visibility buffer. None if the queue was closed.
  std::optional<VisibilityReady> waitForVisibility();
  /// Sends the tile of a moving frame.
  void collected(const render::VisibilityBuffer& buffer, int tile, double seconds) noexcept;

  void begin(const Image& image) noexcept override { image_ = &image; }
  int nextTile() noexcept override;
  void done(int tile, double seconds, bool seenThrough) noexcept override;
  /// Calls done() for all tiles of an image that was traced as a whole.
  void doneAll(const Image& image, double seconds);

 private:
  const int head_;
  const uint64_t id_;
  Outbox& outbox_;
  const Image* image_ = nullptr;
  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<int32_t> tiles_;
  std::optional<VisibilityReady> visibility_;
  std::atomic<bool> closed_{false};
};

}  // namespace gluray::cluster

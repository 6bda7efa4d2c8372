// The thread that traces a worker's share of images, one after the other.
#pragma once
#include "cluster/arrays/array_store.h"
#include "cluster/messages/rank_messages.h"
#include "cluster/pages/page_store.h"
#include "cluster/peers/peer_exchange.h"
#include "cluster/shares/tile_queue.h"
#include "cluster/stream/snapshot_decoder.h"
#include "frame/tracing/renderer.h"
#include "render/tiles/tile_source.h"

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>

namespace gluray::cluster {

class TracingThread {
 public:
  struct Task {
    int head = 0;
    TraceOrder order;
    std::shared_ptr<TileQueue> tiles;  // whoever closes it calls store.wake(), too
  };

  /// `threads`: tracing threads; 0: all that the process may use. `peers`: exchange with the program's peers;
  /// may be null. `pages`: null: snapshots have no pages. All must outlive it.
  TracingThread(ArrayStore& store, Outbox& outbox, int threads, PeerExchange* peers = nullptr,
                PageStore* pages = nullptr);
  /// Waits for the current image. All queues must be closed.
  ~TracingThread();
  TracingThread(const TracingThread&) = delete;
  TracingThread& operator=(const TracingThread&) = delete;

  void add(Task task);

 private:
  void run();
  void trace(const Task& task);
  std::shared_ptr<scene::Snapshot> decode(const TraceOrder& order);
  void render(const Task& task, const scene::Snapshot& snapshot, Finished& result);
  void renderHere(const Task& task, const scene::Snapshot& snapshot, render::TileSource& tiles,
                  Finished& result);
  void renderMoving(const Task& task, const scene::Snapshot& snapshot, Finished& result);
  void send(const Task& task, Finished& result);

  ArrayStore& store_;
  Outbox& outbox_;
  const int threads_;
  PeerExchange* const peers_;
  PageStore* const pages_;
  frame::Renderer renderer_;
  SnapshotDecoder decoder_;
  std::deque<scene::SnapshotPtr> gathered_;  // the last ones: later passes over them find their arrays
  Image image_;
  bool sent_ = false;  // the result of the image
  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<Task> tasks_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace gluray::cluster

// Exchanges occlusion queries with peers for the images of one rank of a sort-last program. Tiles with
// queries are traced twice: first to collect all queries, then with the answers. Messages arrive on the
// worker's main thread; one thread traces, with the threads of its renderer. Before light, ranks tell each
// other their depths, so that each pixel is lit by the rank whose surface is in front (adr/0123).
#pragma once
#include "cluster/messages/peer_messages.h"
#include "cluster/messages/program_messages.h"
#include "cluster/peers/meetings.h"
#include "cluster/peers/near_peer.h"
#include "cluster/peers/part_changes.h"
#include "cluster/peers/peer_depths.h"
#include "cluster/peers/peer_times.h"
#include "cluster/peers/tile_ledger.h"
#include "render/effects/occlusion_answers.h"
#include "render/moving/moving_tile_source.h"
#include "render/remote/remote_surfaces.h"
#include "render/tiles/tiles.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace gluray::cluster {

class PeerExchange final : public render::MovingTileSource, public render::RemoteSurfaces {
 public:
  /// Sends to a peer. Any thread.
  using Send = std::function<void(int peer, std::vector<std::byte> message)>;
  using Say = std::function<void(const std::string&)>;

  /// `self`: this rank, of the program's `ranks`. `say`: one line for the user, any thread.
  PeerExchange(Hash128 program, int self, int ranks, Send send, Say say);

  // The main thread.
  void joins(int rank);
  void leaves(int rank);
  void receive(const SceneComes& coming, double now);
  void receive(const SceneHeld& scene, double now);
  void receive(TileDepths depths, double now);
  void receive(const NoDepths& none, double now);
  void receive(OcclusionQueries queries, double now);
  void receive(const OcclusionReplies& replies, double now);
  void receive(const DoneAsking& done, double now);
  void receive(const StillHere& here, double now);
  /// The program requests an image: the current scene ends as soon as peers have their answers, or at once
  /// if it is of the same view. `shown`: that view, if surfaces of peers may block its light.
  void announce(const std::optional<ViewName>& shown);
  /// Sends signs of life to peers. Call at least ten times a second.
  void tick(double now);
  /// The program has cancelled its image.
  void cancel();
  /// Ends all tracing.
  void close();
  /// Of all images so far. Any thread.
  const PeerTimes& times() const { return times_; }

  // The tracing thread.
  /// Begins the image of announce(). `traced` is called when the image is complete. `meets`: surfaces of
  /// peers may block its light.
  void start(bool averages, bool meets, std::function<void()> traced);
  /// Whether the image must be traced again: without a lost peer, or without averages.
  bool again() const { return again_; }
  bool averages() const { return averages_; }
  /// Releases the scene. Call when tracing has ended, also after failures.
  void finish() noexcept;

  void begin(const Image& image) noexcept override;
  int nextTile() noexcept override;
  void done(int tile, double seconds, bool seenThrough) noexcept override;
  uint32_t index(uint32_t own) const noexcept override { return own; }
  void collected(const render::VisibilityBuffer& buffer, int tile, double seconds) noexcept override;
  bool complete(render::VisibilityBuffer& buffer) noexcept override;
  int nextToColor() noexcept override;
  void begin(const render::FrameData& frame) override;
  void beginEmpty(const scene::Snapshot& snapshot) override;
  accel::Bounds bounds() const noexcept override { return bounds_; }
  bool changed() const noexcept override { return changes_; }
  uint32_t occluded(const render::RemoteQuery& query, uint32_t blocked,
                    render::Passing passing) noexcept override;
  bool recall(uint32_t& blocked) noexcept override;
  bool isReplaying() const noexcept override;
  bool hasDepths() const noexcept override;
  bool exchangeDepths(const render::Tile& tile, const Image& image) noexcept override;
  const render::HiddenPixels& hidden(const render::Tile& tile, const Image& image) noexcept override;
  void hold(const std::function<void()>& whole) noexcept override;

 private:
  using Lock = std::unique_lock<std::mutex>;
  template <class M>
  void sendTo(int peer, M message) const {
    message.address = {program_, self_, peer};
    send_(peer, forRanks(message));
  }
  template <class M>
  void sendToAll(const M& message) const {
    for (int rank = 0; rank < meetings_.ranks(); ++rank)
      if (rank != self_) sendTo(rank, message);
  }
  /// `frame` null: this rank has no surface of the view.
  void meet(const scene::Snapshot& snapshot, const accel::Bounds& bounds, const render::FrameData* frame);
  void addNear();
  void setScene(SceneHeld scene);
  void refuseAll();
  bool isSilent(int rank, double now) const;
  size_t nearOf(int rank) const;  // near_.size(): none
  /// When this thread began what it does for a tile; 0: it traces none.
  static double& began();
  /// Ends what this thread has done since began().
  void spent(PeerTimes::Kind kind) noexcept;
  /// Waits for a change, and counts the time.
  void waitForPeers(Lock& lock);
  /// Of the tile that this thread traces; null: none, or light that was collected before is shown.
  static TileRecord*& record();
  int tileOf(const render::Tile& tile) const {
    return tile.y0 / render::kTileSize * columns_ + tile.x0 / render::kTileSize;
  }
  void orderTiles(const render::Tiles& all);
  bool sharesTile(size_t near, int column, int row) const;
  /// Whether the peer's surfaces may hide some of this rank's in the tile, or the other way round.
  bool mayBeHidden(size_t near, int column, int row) const {
    return near_[near].drawn().mayHide(own_) && sharesTile(near, column, row);
  }
  bool mayHide(size_t near, int column, int row) const {
    return own_.mayHide(near_[near].drawn()) && sharesTile(near, column, row);
  }
  void sendDepths(int number, const render::Tile& tile, const Image& image);
  /// The peer sends no more depths in this round.
  void endDepths(int rank);
  void sendQueries(int tile, TileRecord& record, double now);
  /// Answers one peer's queries, without the lock. Returns false if there are none.
  bool answersOne(Lock& lock) noexcept;
  void answer(const OcclusionQueries& queries) const noexcept;
  void answerAll(std::deque<OcclusionQueries> queries) const;
  void serve(Lock& lock);
  void drop(int rank, const std::string& why);
  bool isAsked(double now) const;
  bool isCancelled() const { return started_ <= cancelled_; }
  bool ends() const { return isCancelled() || closed_ || again_; }

  const Hash128 program_;
  const int self_;
  const Send send_;
  const Say say_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Meetings meetings_;
  std::vector<bool> asking_;   // peers that may send queries about the current scene
  std::vector<double> heard_;  // time of each peer's last message
  std::deque<OcclusionQueries> queries_;
  SceneHeld scene_;                                     // the last one; its round rises with each
  bool held_ = false;                                   // the scene exists, or is being built
  size_t announced_ = 0, started_ = 0, cancelled_ = 0;  // counts of images
  std::optional<ViewName> coming_;                      // whose scene is built
  double saidComing_ = 0, saidHere_ = 0;
  bool closed_ = false;

  // Of the image. What tracing threads read without the lock does not change while they trace.
  std::function<void()> traced_;
  std::atomic<bool> again_{false}, averages_{true};
  const scene::Snapshot* snapshot_ = nullptr;
  std::optional<render::OcclusionAnswers> answers_;
  std::vector<NearPeer> near_;
  accel::Bounds bounds_;
  std::vector<size_t> waiting_;  // beside near_: answers and depths that tiles wait for
  uint64_t attempt_ = 0;
  int refusals_ = 0;
  PartChanges parts_;
  bool changes_ = false;
  PeerDepths depths_;
  std::unordered_map<int, TileDepths> batches_;  // by rank: that wait for more tiles
  render::DrawnPart own_;                        // of the scene; empty: depths are not exchanged
  float depthStep_ = 0;
  bool met_ = false;  // near_ is known
  int columns_ = 0;   // of tiles
  TileLedger ledger_;
  std::vector<int> tiles_;  // of the image
  PeerTimes times_;
  size_t colored_ = 0;  // of them, or being coloured: of moving frames, once all are collected
};

}  // namespace gluray::cluster

// A program that is connected to this worker. The worker's main thread.
#pragma once
#include "cluster/gather/part_gatherer.h"
#include "cluster/local/line.h"
#include "cluster/local/sealed_memory.h"
#include "cluster/messages/program_messages.h"
#include "cluster/worker/requested_image.h"
#include "frame/tracing/pace.h"

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

namespace gluray::cluster {

class ConnectedProgram {
 public:
  explicit ConnectedProgram(Line line) : line_(std::move(line)) {}

  Line& line() { return line_; }
  bool isGone() const { return gone_ || line_.isBroken(); }
  /// Closes the connection at the next opportunity.
  void end() { gone_ = true; }

  template <class M>
  void send(const M& message, int attached = -1) {
    if (!line_.send(M::kType, encoded(message), attached, kPatienceMs)) gone_ = true;
  }

  uint64_t peer = 0;  // its number in PeerPrograms; 0: a program with one process
  std::string name;   // for messages to the user; empty: before its hello
  std::unordered_set<Hash128> arrays;
  std::vector<Hash128> newArrays;  // since the last request
  std::optional<TraceRequest> request;
  using Share = PartGatherer::Share;
  Share share = Share::whole;  // this rank's share of the image; whole for programs with one process
  bool isGathering() const { return share == Share::awaited; }
  /// Whether its image is requested but not begun.
  bool isWaiting() const { return isGathering() || paging.job != 0; }
  bool isWhole() const { return share == Share::whole; }
  /// Enlarges `memory` for an image, and announces it to the program.
  void makeRoom(size_t bytes) {
    if (bytes <= memory.bytes) return;
    memory = writtenMemory(bytes);
    send(ImageMemory{memory.bytes}, memory.memory.get());
  }
  /// Its images show the geometry of all ranks, so that all workers need it.
  bool spreads = true;
  int ranks = 1;            // of the program
  uint64_t arrayBytes = 0;  // of `arrays`
  struct Paging {
    uint64_t number = 0;  // of the program, for PageMaker
    uint64_t job = 0;     // that cuts the snapshot of `request`; 0: none
    std::shared_ptr<std::atomic<bool>> cancelled;
  };
  Paging paging;
  std::optional<TraceRequest> paged;  // `request`, its geometry in pages
  /// The request with its geometry for gathered images.
  const TraceRequest& given() const { return paged ? *paged : *request; }
  std::optional<RequestedImage> image;
  WrittenMemory memory;
  std::map<uint64_t, std::vector<float>> costs;  // of tiles, by view
  struct Animation {
    frame::Pace pace;
    uint32_t frames = 0;
  };
  std::map<uint64_t, Animation> animations;  // by view
  std::optional<Hash128> visibility;         // array of the moving image that is at work
  double saidAtWork = 0;

 private:
  static constexpr int kPatienceMs = 200;  // for a program that does not read
  Line line_;
  bool gone_ = false;
};

}  // namespace gluray::cluster

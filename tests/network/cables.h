// What a switch and its cables do to frames: when each arrives, and whether it does. Without a clock and
// interfaces of its own. Times are nanoseconds of a steady clock.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <queue>
#include <random>
#include <string>
#include <vector>

namespace network {

using Bytes = std::vector<uint8_t>;  // an Ethernet frame

struct Cable {
  int64_t delayNs = 0;                        // each way
  double bitsPerSecond = 0;                   // each way; 0: no limit
  double lostShare = 0;                       // 0 to 1
  int64_t sendsUntil = 0, receivesUntil = 0;  // times at which the last frame will have passed
};

/// A switch that keeps whole frames, learns which cable an address is at, and has `kBufferBytes` for each
/// cable.
class Cables {
 public:
  static constexpr int64_t kBufferBytes = 512 << 10;
  static constexpr int64_t kSendAheadBytes = 64 << 10;  // a host's own queue for its cable

  explicit Cables(size_t count);
  size_t count() const { return cables_.size(); }
  Cable& at(size_t cable) { return cables_[cable]; }
  /// A cable itself (a == b), or what two cables say to each other.
  void setCut(size_t a, size_t b, bool isCut);
  /// Bytes of delivered frames, "from 0 to 0, from 0 to 1, ...; from 1 to 0, ...": numbers with spaces
  /// between, and a semicolon between rows.
  std::string bytesText() const;

  /// Whether the host at the cable may send a frame now.
  bool takesFrom(size_t cable, int64_t now) const;
  /// The host at the cable sends a frame.
  void sent(size_t cable, Bytes frame, int64_t now);
  /// Hands over all frames that arrive until now. `deliver` says whether the host took the frame.
  void advance(int64_t now, const std::function<bool(size_t to, const Bytes& frame)>& deliver);
  /// When something happens next; negative: nothing will.
  int64_t next(int64_t now) const;
  /// An empty frame of that size, to be filled.
  Bytes buffer(size_t size);

 private:
  using Address = std::array<uint8_t, 6>;
  struct Travel {
    int64_t due;
    uint64_t order;  // of two frames with one time the earlier one first
    size_t from, to;
    Bytes frame;
  };
  struct Later {
    bool operator()(const Travel& a, const Travel& b) const {
      return a.due != b.due ? a.due > b.due : a.order > b.order;
    }
  };
  using Queue = std::priority_queue<Travel, std::vector<Travel>, Later>;

  bool isLost(size_t from, size_t to);
  bool isCut(size_t from, size_t to) const;
  void forward(Travel travel);
  void forwardTo(size_t to, const Travel& travel, Bytes frame);
  static Travel pop(Queue& queue);

  std::vector<Cable> cables_;
  std::vector<std::vector<bool>> cut_;
  std::vector<std::vector<uint64_t>> bytes_;
  std::map<Address, size_t> places_;
  Queue sending_;     // on their way to the switch
  Queue delivering_;  // on their way from it
  uint64_t order_ = 0;
  std::minstd_rand random_{1};
  std::vector<Bytes> spare_;
};

}  // namespace network

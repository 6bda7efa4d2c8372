// Keeps only the newest event of each kind for a slow client, and limits events to the rate that the client
// requests. On the hub's thread.
#pragma once
#include "control/hub/peers.h"

#include <deque>
#include <map>
#include <string>
#include <utility>

namespace gluray::control {

class Newest {
 public:
  using Key = std::pair<uint64_t, std::string>;  // program, `what`
  using Send = std::function<void(uint64_t program, const PeerLink::Line&)>;

  /// Sends the line, or keeps it in place of the previous one. `every`: seconds between two events of this
  /// key.
  void offer(const Key& key, PeerLink::Line line, double every, HubTime now, bool slow, const Send& send);
  /// Sends kept lines that are due, oldest first, while `slow` returns false.
  void flush(HubTime now, const std::function<bool()>& slow, const Send& send);
  void forget(uint64_t program);
  void forget(const Key& key);
  /// Time when the next kept line may be sent.
  HubTime nextDue() const;

 private:
  struct Slot {
    PeerLink::Line kept;  // null: nothing waits
    HubTime due{};        // not sent before
    double every = 0;
    uint64_t order = 0;  // order among waiting lines
  };
  std::map<Key, Slot> slots_;
  uint64_t last_ = 0;
};

}  // namespace gluray::control

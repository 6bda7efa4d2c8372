// Plays what peers send to a hub without sockets, and checks what the hub says: every line can be read, every
// request with an id is answered once, nothing is thrown. A mistake is printed, and the process aborts.
#pragma once
#include "control/hub/hub_core.h"
#include "control/messages/parsed.h"

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gluray::fuzz {

class HubPlayer {
 public:
  /// A new connection; its index.
  size_t connect();
  size_t peers() const { return peers_.size(); }
  /// Bytes of a connection, of any content.
  void feed(size_t peer, std::string_view bytes);
  void disconnect(size_t peer);
  void wait(std::chrono::milliseconds time);
  /// Whether the peer reads slowly.
  void slow(size_t peer, bool slow);
  /// Questions that the hub asked a program and that it has not answered; removes them.
  std::vector<nlohmann::json> questions(size_t peer);
  /// Lets all time limits pass: then no request may wait.
  void end();
  bool open(size_t peer) const { return peers_[peer]->open; }
  /// Messages that the hub was given, its answers, and what it asked programs.
  struct Counts {
    uint64_t messages = 0, answers = 0, asked = 0;
  };
  const Counts& counts() const { return counts_; }

 private:
  struct One {
    control::LineReader reader;
    bool open = true, client = false, program = false;
    size_t waiting = 0;
    std::set<std::string> asked;  // ids that wait for an answer, as text
    std::vector<nlohmann::json> questions;
    size_t errors = 0;
  };
  void message(size_t peer, const nlohmann::json& message);
  void sent(size_t peer, const std::string& line);

  control::HubTime now_{std::chrono::seconds(1000)};
  control::HubCore hub_{control::HubCore::Self{"host", 1, 0}};
  std::vector<std::unique_ptr<One>> peers_;  // connection numbers are one more than indices
  Counts counts_;
};

}  // namespace gluray::fuzz

// The hub's pending requests to programs. On the hub's thread.
#pragma once
#include "control/hub/peers.h"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace gluray::control {

class Questions {
 public:
  /// Gets the program's result: an object, which has `why` where the program has failed, ended, or not
  /// answered.
  using Done = std::function<void(nlohmann::json&& result)>;

  explicit Questions(Peers& peers) : peers_(peers) {}

  /// The time of all that follows.
  void setNow(HubTime now) { now_ = now; }
  HubTime now() const { return now_; }

  /// Sends the request under a new id. Calls `done` once, never before it returns. `patience`: how long it
  /// waits.
  uint64_t ask(uint64_t program, nlohmann::json message, std::chrono::milliseconds patience, Done done);
  /// The same without a limit.
  uint64_t askForever(uint64_t program, nlohmann::json message, Done done);
  /// Sends a request whose answer nobody needs.
  void tell(uint64_t program, nlohmann::json message);

  /// Takes a message of type `answer`. Ignores one that nobody waits for.
  void answered(uint64_t program, const nlohmann::json& message);
  /// The connection is gone: its questions end.
  void ended(uint64_t program);
  /// Ends questions whose limit has passed.
  void passed();
  /// When the next limit passes.
  HubTime nextDue() const { return limits_.empty() ? HubTime::max() : limits_.begin()->first; }

 private:
  struct Question {
    uint64_t program;
    HubTime limit;
    std::string why;  // the result when the limit has passed
    Done done;
  };
  uint64_t add(uint64_t program, nlohmann::json&& message, HubTime limit, std::string why, Done&& done);
  void end(uint64_t id, nlohmann::json&& result);

  Peers& peers_;
  HubTime now_{};
  uint64_t last_ = 0;
  std::map<uint64_t, Question> questions_;
  std::set<std::pair<HubTime, uint64_t>> limits_;
};

/// {"why": why}
nlohmann::json failure(const std::string& why);
/// The `why` of a result; empty: it has none.
std::string whyOf(const nlohmann::json& result);

}  // namespace gluray::control

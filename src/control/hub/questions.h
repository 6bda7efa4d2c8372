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
  /// Receives the program's result: an object, with `why` if the program failed, ended, or did not answer.
  using Done = std::function<void(nlohmann::json&& result)>;

  explicit Questions(Peers& peers) : peers_(peers) {}

  /// Sets the time for all following calls.
  void setNow(HubTime now) { now_ = now; }
  HubTime now() const { return now_; }

  /// Sends the request under a new id. Calls `done` once, after returning. `patience`: time limit.
  uint64_t ask(uint64_t program, nlohmann::json message, std::chrono::milliseconds patience, Done done);
  /// Like ask(), without a time limit.
  uint64_t askForever(uint64_t program, nlohmann::json message, Done done);
  /// Sends a request without waiting for its answer.
  void tell(uint64_t program, nlohmann::json message);

  /// Handles a message of type `answer`. Ignores answers that are not expected.
  void answered(uint64_t program, const nlohmann::json& message);
  /// Reports that the connection is closed: its requests end.
  void ended(uint64_t program);
  /// Ends requests whose time limit has passed.
  void passed();
  /// Time of the next limit.
  HubTime nextDue() const { return limits_.empty() ? HubTime::max() : limits_.begin()->first; }

 private:
  struct Question {
    uint64_t program;
    HubTime limit;
    std::string why;  // the result after the time limit
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
/// The `why` of a result; empty if it has none.
std::string whyOf(const nlohmann::json& result);

}  // namespace gluray::control

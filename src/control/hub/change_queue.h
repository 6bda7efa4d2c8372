// Requests that change a program (set, undo, redo), one at a time. On the hub's thread.
#pragma once
#include "control/hub/programs.h"
#include "control/hub/questions.h"

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gluray::control {

inline constexpr std::chrono::seconds kSetPatience{3};  // limit for an answer, and for the wait before

/// A client's request to change a program.
struct ChangeRequest {
  std::string type;  // set, undo, redo
  uint64_t client = 0;
  std::string gesture;    // of this client; empty: none
  nlohmann::json values;  // of set
};

class ChangeQueue {
 public:
  /// `self`: text that no other hub has. Gestures are passed on under names that contain it.
  ChangeQueue(Programs& programs, Questions& questions, std::string self)
      : programs_(programs), questions_(questions), self_(std::move(self)) {}

  /// Carries out the request after those that already wait for the same program. Calls `done` once, perhaps
  /// before it returns.
  void add(uint64_t program, ChangeRequest request, Questions::Done done);
  /// Fails requests that have waited too long.
  void passed();
  HubTime nextDue() const;
  /// Reports that the program has ended: its waiting requests fail.
  void ended(uint64_t program);

 private:
  struct Part {
    nlohmann::json values;
    HubTime limit;  // until when it waits
    Questions::Done done;
  };
  struct Change {
    ChangeRequest request;
    std::vector<Part> parts;
    bool alone = false;  // not merged with other requests
  };
  struct Line {
    std::optional<Change> current;  // in flight
    std::deque<Change> waiting;
  };
  void begin(uint64_t program);
  void send(const Program& entry);
  void finished(uint64_t program, nlohmann::json&& result);
  nlohmann::json messageOf(const Change& change) const;
  std::string gestureName(const ChangeRequest& request) const;

  Programs& programs_;
  Questions& questions_;
  const std::string self_;
  std::map<uint64_t, Line> lines_;  // by program; only programs with a change
};

}  // namespace gluray::control

// Requests that change settings: set, undo and redo; for MPI jobs also hold, apply, draw and drop. They are
// answered when a frame has begun with the new values. Control thread; times in seconds.
#pragma once
#include "settings/live/live_settings.h"
#include "settings/live/settings_history.h"

#include <nlohmann/json.hpp>

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gluray::control {

class ChangeRequests {
 public:
  static constexpr double kPatience = 0.5;   // limit for a frame with the values
  static constexpr double kQuiet = 0.1;      // without a frame for that long, the program is idle
  static constexpr double kAskAgain = 0.15;  // between two requests to draw
  static constexpr double kPoll = 0.004;     // interval of checks for frames
  static constexpr double kHoldSeconds = 5;
  static constexpr size_t kMaxHeld = 16, kMaxWaiting = 256, kMaxValueBytes = size_t{16} << 10;
  static constexpr size_t kMaxNameBytes =
      256;  // bytes of the name of an unknown setting that an answer quotes

  /// Receives the result; it has `why` if the request is refused.
  using Answer = std::function<void(const nlohmann::json& id, nlohmann::json result)>;
  /// `history` outlives this, because hubs come and go.
  ChangeRequests(LiveSettings& live, const SettingsSource& source, SettingsHistory& history,
                 std::function<void()> wake, Answer answer)
      : live_(live), source_(source), history_(history), wake_(std::move(wake)), answer_(std::move(answer)) {}

  /// Whether receiveRequest() handles the type.
  static bool knows(const std::string& type);
  void receiveRequest(const std::string& type, const nlohmann::json& id, const nlohmann::json& message,
                      double now);
  /// Answers requests, requests frames, and drops held changes that are due.
  void passed(double now);
  /// Time of the next call of passed(); infinity if only a request makes it necessary.
  double nextDue(double now) const;

  const SettingsHistory& history() const { return history_; }

 private:
  using Changes = LiveSettings::Changes;
  enum class Kind { set, undo, redo };
  struct Change {
    Kind kind = Kind::set;
    Changes changes;
    std::string gesture;
  };
  struct Held {
    nlohmann::json id;
    Change change;
    double until;
    std::optional<LiveSettings::Answer> applied;
  };
  struct Waiting {
    nlohmann::json id;
    LiveSettings::Answer answer;
    std::vector<std::string> names;
    double until, wake;
  };
  std::string read(const std::string& type, const nlohmann::json& message, Change& change) const;
  std::string make(const Change& change, uint64_t frame, LiveSettings::Answer& answer);
  void hold(const nlohmann::json& id, Change&& change, double now);
  void apply(const nlohmann::json& id, Held& held, const nlohmann::json& message);
  void wait(const nlohmann::json& id, const Change& change, LiveSettings::Answer&& answer, double now);
  bool answered(const Waiting& waiting, double now);
  void refuse(const nlohmann::json& id, const std::string& why);

  LiveSettings& live_;
  const SettingsSource& source_;
  SettingsHistory& history_;
  const std::function<void()> wake_;
  const Answer answer_;
  std::deque<Held> held_;
  std::vector<Waiting> waiting_;
};

}  // namespace gluray::control

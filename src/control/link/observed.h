// The hub's subscriptions: the program's state, changes of settings, and thumbnails. Control thread; times in
// seconds.
#pragma once
#include "control/link/image_requests.h"
#include "control/link/program/controlled_program.h"
#include "control/link/rates.h"
#include "settings/live/live_settings.h"
#include "settings/live/settings_history.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <string>

namespace gluray::control {

/// A setting's value, layer and place as JSON.
nlohmann::json described(const LiveSettings::Value& value);

class Observed {
 public:
  static constexpr double kMinInterval = 0.05, kMaxInterval = 3600;
  static constexpr double kSample = 0.25;  // maximum interval of samples for rates

  using Send = std::function<void(nlohmann::json event)>;
  Observed(ControlledProgram& program, LiveSettings& live, const SettingsSource& source, Send send)
      : program_(program), live_(live), source_(source), send_(std::move(send)) {}

  /// Replaces the subscription. Returns the answer; it has `why` if the request is wrong.
  nlohmann::json observeRequested(const nlohmann::json& message, double now);
  /// Sends events that are due. `slow`: the hub does not read what was sent; states are skipped.
  void passed(const SettingsHistory& history, bool slow, double now);
  double nextDue() const;
  /// The subscription to thumbnails.
  const ThumbnailWish& thumbnails() const { return thumbnails_; }

 private:
  void sendState();
  void sendSettings(const SettingsHistory& history);

  ControlledProgram& program_;
  LiveSettings& live_;
  const SettingsSource& source_;
  const Send send_;
  bool state_ = false, settings_ = false;
  ThumbnailWish thumbnails_;
  bool first_ = true;  // no settings sent since observeRequested()
  double every_ = 1, nextState_ = 0, nextLook_ = 0;
  uint64_t revision_ = 0;  // revision of the settings that were sent
  size_t undo_ = 0, redo_ = 0;
  std::map<std::string, LiveSettings::Value, std::less<>> sent_;
  Rates rates_;
};

}  // namespace gluray::control

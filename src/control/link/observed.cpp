#include "control/link/observed.h"

#include "control/messages/members.h"
#include "control/messages/value.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gluray::control {

using nlohmann::json;

json described(const LiveSettings::Value& value) {
  return {{"value", valueOf(*value.row, value.text)}, {"layer", nameOf(value.layer)}, {"place", value.place}};
}

json Observed::observeRequested(const json& message, double now) {
  const json *const what = member(message, "what"), *const every = member(message, "every");
  if (!what || !what->is_array()) return {{"why", "what must be a list"}};
  if (every && !every->is_number()) return {{"why", "every must be a number of seconds"}};
  const auto names = [&](const char* name) {
    return std::find(what->begin(), what->end(), name) != what->end();
  };
  const json* const askedSize = member(message, "size");
  const auto size = wholeNumber(askedSize, ThumbnailWish::kMinSize, ThumbnailWish::kMaxSize);
  if (askedSize && !size) return {{"why", "size must be a number of pixels from 16 to 512"}};
  every_ = every ? every->get<double>() : 1;
  every_ = every_ >= kMinInterval ? std::min(every_, kMaxInterval) : kMinInterval;  // also if it is NaN
  state_ = names("state"), settings_ = names("settings");
  thumbnails_ = {names("thumbnail"), size ? static_cast<int>(*size) : ThumbnailWish::kUsualSize, every_};
  first_ = true;
  nextState_ = nextLook_ = now;
  sent_.clear();
  if (!state_) rates_.clear();
  return json::object();
}

double Observed::nextDue() const {
  double next = std::numeric_limits<double>::infinity();
  if (state_) next = std::min(nextState_, nextLook_);
  return settings_ ? std::min(next, nextLook_) : next;
}

void Observed::passed(const SettingsHistory& history, bool slow, double now) {
  const bool due = now >= nextLook_;
  if (due) nextLook_ = now + std::min(every_, kSample);
  if (state_ && due) rates_.sample(source_.begun().frame, program_.figures(), now);
  if (state_ && now >= nextState_) {
    nextState_ = std::max(nextState_ + every_, now + every_ / 2);
    if (!slow) sendState();
  }
  if (settings_) sendSettings(history);
}

void Observed::sendState() {
  json state = program_.state();
  if (!state.is_object()) state = json::object();
  const auto traced = rates_.traced();
  state["frame"] = source_.begun().frame;
  state["fps"] = rates_.framesPerSecond();
  state["triangles"] = rates_.triangles();
  state["traced"] = traced ? json(*traced) : json();
  send_({{"type", "event"}, {"what", "state"}, {"state", std::move(state)}});
}

void Observed::sendSettings(const SettingsHistory& history) {
  const uint64_t revision = live_.revision();
  const bool steps = undo_ != history.undoSteps() || redo_ != history.redoSteps();
  if (!first_ && !steps && revision == revision_) return;
  json values = json::object();
  for (LiveSettings::Value& value : live_.values()) {
    const auto known = sent_.find(value.row->name);
    const bool isNew = known == sent_.end() ? value.layer != Layer::builtIn : !(known->second == value);
    if (!isNew) continue;
    values[std::string(value.row->name)] = described(value);
    sent_.insert_or_assign(std::string(value.row->name), std::move(value));
  }
  revision_ = revision, undo_ = history.undoSteps(), redo_ = history.redoSteps();
  if (!std::exchange(first_, false) && values.empty() && !steps) return;
  send_({{"type", "event"},
         {"what", "settings"},
         {"values", std::move(values)},
         {"undo", undo_},
         {"redo", redo_}});
}

}  // namespace gluray::control

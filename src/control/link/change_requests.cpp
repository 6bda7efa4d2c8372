#include "control/link/change_requests.h"

#include "control/messages/members.h"
#include "control/messages/value.h"
#include "settings/values.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gluray::control {
namespace {

using nlohmann::json;

/// Parses the changes in `values`. Returns an error message if there are none.
std::string readChanges(const json* values, LiveSettings::Changes& changes) {
  if (!values || !values->is_object()) return "values must be an object of settings and their values";
  for (const auto& [name, value] : values->items()) {
    const Row* const row = findSetting(name);
    if (!row) return unknownSetting(name.substr(0, ChangeRequests::kMaxNameBytes));
    if (value.is_null()) {
      changes.push_back({name, std::nullopt});
      continue;
    }
    TextOrWhy text = textOf(*row, value);
    if (!text.why.empty()) return text.why;
    if (text.text.size() > ChangeRequests::kMaxValueBytes) return name + ": the value is longer than 16 KiB";
    changes.push_back({name, std::move(text.text)});
  }
  return "";
}

}  // namespace

bool ChangeRequests::knows(const std::string& type) {
  return type == "set" || type == "undo" || type == "redo" || type == "apply" || type == "draw" ||
         type == "drop";
}

void ChangeRequests::refuse(const json& id, const std::string& why) { answer_(id, json{{"why", why}}); }

void ChangeRequests::receiveRequest(const std::string& type, const json& id, const json& message,
                                    double now) {
  if (type == "apply" || type == "draw" || type == "drop") {
    const json* const of = member(message, "of");
    const auto held =
        std::find_if(held_.begin(), held_.end(), [&](const Held& h) { return of && h.id == *of; });
    if (type == "drop") {
      if (held != held_.end() && !held->applied) held_.erase(held);
      return answer_(id, json::object());
    }
    if (held == held_.end()) return refuse(id, "nothing is held under this number");
    if (type == "apply") return apply(id, *held, message);
    if (!held->applied) return refuse(id, "what is held was not applied");
    const Held done = std::move(*held);
    held_.erase(held);
    return wait(id, done.change, LiveSettings::Answer(*done.applied), now);
  }
  Change change;
  std::string why = read(type, message, change);
  if (why.empty() && isTrue(member(message, "hold"))) return hold(id, std::move(change), now);
  LiveSettings::Answer answer;
  if (why.empty() && waiting_.size() >= kMaxWaiting) why = "too many requests wait for a frame";
  if (why.empty()) why = make(change, 0, answer);
  if (!why.empty()) return refuse(id, why);
  wait(id, change, std::move(answer), now);
}

std::string ChangeRequests::read(const std::string& type, const json& message, Change& change) const {
  if (type == "set") {
    const auto gesture = textMember(message, "gesture", kMaxCharacters, "");
    if (!gesture) return "gesture must be a short text";
    change.gesture = *gesture;
    return readChanges(member(message, "values"), change.changes);
  }
  const bool undo = type == "undo";
  if ((undo ? history_.undoSteps() : history_.redoSteps()) == 0)
    return undo ? "there is nothing to undo" : "there is nothing to redo";
  change.kind = undo ? Kind::undo : Kind::redo;
  change.changes = undo ? history_.undoing() : history_.redoing();
  return "";
}

/// Makes the change from a frame on. Returns an error message.
std::string ChangeRequests::make(const Change& change, uint64_t frame, LiveSettings::Answer& answer) {
  answer = live_.change(change.changes, frame);
  if (!answer.why.empty()) return answer.why;
  switch (change.kind) {
    case Kind::set: history_.add(change.changes, answer.before, change.gesture); break;
    case Kind::undo: history_.undone(); break;
    case Kind::redo: history_.redone(); break;
  }
  return "";
}

void ChangeRequests::hold(const json& id, Change&& change, double now) {
  if (const std::string why = live_.whyNot(change.changes); !why.empty()) return refuse(id, why);
  std::erase_if(held_, [&](const Held& h) { return h.id == id; });
  if (held_.size() >= kMaxHeld) held_.pop_front();
  held_.push_back({id, std::move(change), now + kHoldSeconds, std::nullopt});
  const SettingsSource::Begun begun = source_.begun();
  json result{{"frame", begun.frame}, {"drawing", begun.active > 0 && now - begun.active < kPatience}};
  if (begun.began > 0) result["age"] = std::max(now - begun.began, 0.0);
  if (begun.before > 0) result["period"] = std::max(begun.began - begun.before, 0.0);
  answer_(id, std::move(result));
}

void ChangeRequests::apply(const json& id, Held& held, const json& message) {
  const auto asked = wholeNumber(member(message, "frame"), 0, kMaxFrame);
  if (!asked) return refuse(id, "frame must be a whole number");
  if (held.applied) return refuse(id, "what is held was applied before");
  const auto frame = static_cast<uint64_t>(*asked);
  const bool late = source_.begun().frame >= frame;
  LiveSettings::Answer answer;
  if (const std::string why = make(held.change, frame, answer); !why.empty()) return refuse(id, why);
  held.applied = std::move(answer);
  answer_(id, json{{"frame", frame}, {"late", late}});
}

void ChangeRequests::wait(const json& id, const Change& change, LiveSettings::Answer&& answer, double now) {
  Waiting waiting{id, std::move(answer), {}, now + kPatience, now};
  for (const auto& c : change.changes) waiting.names.push_back(c.name);
  const double active = source_.begun().active;
  if (active > 0 && now - active < kQuiet) waiting.wake = now + kQuiet;
  waiting_.push_back(std::move(waiting));
  passed(now);
}

bool ChangeRequests::answered(const Waiting& waiting, double now) {
  const std::optional<uint64_t> frame = live_.firstFrameWith(waiting.answer);
  if (!frame && now < waiting.until) return false;
  json values = json::object();
  for (const LiveSettings::Value& v : live_.values(/*waiting=*/true))
    if (std::find(waiting.names.begin(), waiting.names.end(), v.row->name) != waiting.names.end())
      values[std::string(v.row->name)] = valueOf(*v.row, v.text);
  answer_(waiting.id, json{{"frame", frame ? json(*frame) : json()}, {"values", std::move(values)}});
  return true;
}

void ChangeRequests::passed(double now) {
  std::erase_if(waiting_, [&](const Waiting& waiting) { return answered(waiting, now); });
  bool wake = false;
  for (Waiting& waiting : waiting_)
    if (now >= waiting.wake) wake = true, waiting.wake = now + kAskAgain;
  if (wake) wake_();
  std::erase_if(held_, [&](const Held& held) { return now >= held.until; });
}

double ChangeRequests::nextDue(double now) const {
  double next = std::numeric_limits<double>::infinity();
  if (!waiting_.empty()) next = now + kPoll;
  for (const Held& held : held_) next = std::min(next, held.until);
  return next;
}

}  // namespace gluray::control

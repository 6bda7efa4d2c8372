// What Controls asks of the hub and its programs.
#include "model/controls.h"

#include <algorithm>
#include <utility>

namespace gluray::panel {
namespace {

using nlohmann::json;

constexpr double kStateSeconds = 0.25;  // between events

}  // namespace

json Controls::target() const { return chosen_ ? json(*chosen_) : json("all"); }

void Controls::request(json message, const QString& what) {
  message["id"] = next_;
  asked_[next_++] = what;
  send_(std::move(message));
}

void Controls::set(const std::string& name, const json& value, const std::string& gesture) {
  change({{name, value}}, gesture);
}

void Controls::change(const json& values, const std::string& gesture) {
  if ((!chosen_ && !all_) || !values.is_object() || values.empty()) return;
  json message{{"type", "set"}, {"program", target()}, {"values", values}};
  if (!gesture.empty()) message["gesture"] = gesture;
  request(std::move(message), QString::fromStdString(values.begin().key()));
}

void Controls::undo() {
  if (chosen_ || all_) request({{"type", "undo"}, {"program", target()}}, tr("undo"));
}

void Controls::redo() {
  if (chosen_ || all_) request({{"type", "redo"}, {"program", target()}}, tr("redo"));
}

void Controls::call(int program, const char* name, json arguments, QObject* receiver, CallTaker then) {
  calls_.wait(next_, program, receiver, [then = std::move(then)](const std::vector<CallAnswer>& answers) {
    if (!answers.empty()) then(answers.front());
  });
  send_({{"type", "call"},
         {"id", next_++},
         {"program", program},
         {"name", name},
         {"arguments", std::move(arguments)}});
}

void Controls::batch(int program, json requests, QObject* receiver, BatchTaker then) {
  for (json& request : requests) request["program"] = program;
  calls_.wait(next_, program, receiver, std::move(then), true);
  send_({{"type", "batch"}, {"id", next_++}, {"requests", std::move(requests)}});
}

void Controls::wantThumbnails(const QObject* who, int size) {
  size > 0 ? void(sizes_[who] = std::min(size, kMaxThumbnailPixels)) : void(sizes_.erase(who));
  if (isConnected_) observe();
}

void Controls::observe() {
  json message{{"type", "observe"},
               {"program", "all"},
               {"what", {"programs", "settings", "state", "thumbnail"}},
               {"every", kStateSeconds}};
  int size = 0;
  for (const auto& [who, wanted] : sizes_) size = std::max(size, wanted);
  if (size > 0) message["size"] = size;
  request(std::move(message));
}

}  // namespace gluray::panel

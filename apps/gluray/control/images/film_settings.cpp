#include "control/images/film_settings.h"

#include "control/messages/members.h"

#include <random>

namespace gluray::launcher {
namespace {

using nlohmann::json;

/// A name that no other film has.
std::string freshGesture() {
  std::random_device device;
  return "film " + std::to_string(device()) + " " + std::to_string(device());
}

}  // namespace

FilmSettings::FilmSettings(HubSession& hub, const RunningProgram& program, std::vector<Ramp> ramps)
    : hub_(hub), program_(program), ramps_(std::move(ramps)), gesture_(freshGesture()) {
  if (ramps_.empty()) return;
  std::vector<std::string> names;
  for (const Ramp& ramp : ramps_) names.push_back(ramp.name);
  const json described = describedIn(hub, program, names);
  for (const auto& [name, one] : described.items())
    before_[name] = control::textIn(one, "layer") == "live" ? one["value"] : json();
}

std::optional<int64_t> FilmSettings::send(const json& values) {
  const json result = resultOf(hub_, program_, {{"type", "set"}, {"values", values}, {"gesture", gesture_}});
  return control::wholeNumber(control::member(result, "frame"), 0, control::kMaxFrame);
}

json FilmSettings::values(int image, int of) const {
  json values = json::object();
  for (const Ramp& ramp : ramps_) values[ramp.name] = ramp.value(image, of);
  return values;
}

bool FilmSettings::same(int image, int of) const {
  return !ramps_.empty() && image > 1 && values(image, of) == values(image - 1, of);
}

std::optional<int64_t> FilmSettings::set(int image, int of) {
  if (ramps_.empty() || same(image, of)) return std::nullopt;
  changed_ = true;
  return send(values(image, of));
}

void FilmSettings::giveBack() {
  if (changed_) changed_ = false, send(before_);
}

}  // namespace gluray::launcher

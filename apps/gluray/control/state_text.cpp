#include "control/state_text.h"

#include "text_table.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace gluray::launcher {
namespace {

using nlohmann::json;

std::optional<double> numberOf(const json& state, const char* name) {
  const auto found = state.find(name);
  if (found == state.end() || !found->is_number()) return std::nullopt;
  const double number = found->get<double>();
  return std::isfinite(number) && std::fabs(number) < 1e18 ? std::optional(number) : std::nullopt;
}

std::string countText(double number) {
  return grouped(static_cast<unsigned long long>(std::fmax(number, 0)));
}

/// With three significant digits.
std::string noiseText(double noise) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", noise);
  return text;
}

}  // namespace

std::string stateText(const json& state) {
  std::string text;
  if (!state.is_object()) return text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (const auto frame = numberOf(state, "frame")) add("frame " + fixed(*frame, 0));
  if (const auto fps = numberOf(state, "fps")) add(fixed(*fps, 1) + " fps");
  if (const auto triangles = numberOf(state, "triangles")) add(countText(*triangles) + " triangles");
  if (const auto traced = numberOf(state, "traced")) add(fixed(100 * *traced, 1) + " % traced");
  if (const auto memory = numberOf(state, "memory")) add(countText(*memory / 1e6) + " MB");
  if (const auto noise = numberOf(state, "noise")) add("noise " + noiseText(*noise));
  if (const auto passes = numberOf(state, "passes")) add(fixed(*passes, 0) + " passes");
  if (const auto progress = state.find("progress"); progress != state.end() && progress->is_object())
    if (const auto share = numberOf(*progress, "share")) {
      add(fixed(100 * *share, 0) + " % refined");
      if (const auto left = numberOf(*progress, "secondsLeft")) add(fixed(*left, 0) + " s left");
    }
  if (const auto building = state.find("building"); building != state.end() && *building == true)
    add("building a better structure");
  return text;
}

}  // namespace gluray::launcher

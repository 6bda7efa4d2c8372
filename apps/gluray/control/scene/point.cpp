#include "control/scene/point.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gluray::launcher {
namespace {

constexpr double kMaxCoordinate = 1 << 15;  // pixels

/// "240", "50%". Empty, or what is wrong.
std::string readCoordinate(std::string text, double& value, bool& percent) {
  const std::string why = text.substr(0, 40) + ": use pixels, such as 320 240, or percent from 0% to 100%";
  percent = text.ends_with('%');
  if (percent) text.pop_back();
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  const bool number = error == std::errc() && last == end && std::isfinite(value);
  return number && value >= 0 && value <= (percent ? 100 : kMaxCoordinate) ? "" : why;
}

}  // namespace

std::string readPoint(const std::string& command, const std::vector<std::string>& words, Point& point) {
  const auto first = static_cast<size_t>(std::ranges::count(command, ' '));  // "pick" is not among `words`
  if (words.size() != first + 2) return "use gluray " + command + " X Y, such as 320 240 or 50% 50%";
  const std::string &x = words[first], &y = words[first + 1];
  bool percent = false;
  if (std::string why = readCoordinate(x, point.x, point.percent); !why.empty()) return why;
  if (std::string why = readCoordinate(y, point.y, percent); !why.empty()) return why;
  return percent == point.percent ? "" : x + " " + y + ": use pixels or percent for both";
}

nlohmann::json argumentsOf(const Point& point) {
  nlohmann::json arguments = {{"x", point.x}, {"y", point.y}};
  if (point.percent) arguments["width"] = arguments["height"] = 100;
  return arguments;
}

}  // namespace gluray::launcher

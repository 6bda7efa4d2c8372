// A point of a window's image, as users give it: X Y in pixels from the top left, or in percent.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace gluray::launcher {

struct Point {
  double x = 0, y = 0;
  bool percent = false;  // of the image's width and height
};

/// Reads what follows the words of `command` in `words`: "320" "240", or "50%" "50%". `command` is "pick",
/// "light at". Empty, or one line that says what is wrong.
std::string readPoint(const std::string& command, const std::vector<std::string>& words, Point& point);

/// The arguments of the calls pick and highlight.
nlohmann::json argumentsOf(const Point& point);

}  // namespace gluray::launcher

// A point of a window's picture, as users give it: X Y in pixels from the top left, or in percent.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::launcher {

struct Point {
  double x = 0, y = 0;
  bool percent = false;  // of the picture's width and height
};

/// Reads "320" "240", or "50%" "50%". Empty, or one line that says what is wrong.
std::string readPoint(const std::string& x, const std::string& y, Point& point);

/// The arguments of the calls pick and highlight.
nlohmann::json argumentsOf(const Point& point);

}  // namespace gluray::launcher

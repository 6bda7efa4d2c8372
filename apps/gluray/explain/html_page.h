// The page of `gluray explain --html`: one file that holds everything, pictures included.
#pragma once
#include "explain/pixels.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace gluray::launcher {

/// One frame of a program, as two runs of it showed it.
struct FramePictures {
  Pixels with, origin;                   // the run with GLuRay, and what of its picture was traced
  std::optional<Pixels> without;         // the run without; absent where there is no such picture
  uint64_t frame = 0, frameWithout = 0;  // counted from 1
  uint64_t elsewhere = 0;                // pixels traced into framebuffer objects
  bool perPixel = true;                  // lighting was evaluated at each pixel
  bool atRest = false;  // the frame after which nothing new came, rather than one of equal number
};

/// Throws std::runtime_error. `text` is what is printed as well.
std::string htmlPage(const std::string& command, const std::string& text, const FramePictures& pictures);

/// What the page's numbers are, as JSON.
nlohmann::json pictureFacts(const FramePictures& pictures);

}  // namespace gluray::launcher

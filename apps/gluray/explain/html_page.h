// The page of `gluray explain --html`: one self-contained file, images included.
#pragma once
#include "explain/pixels.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace gluray::launcher {

/// One frame from two runs of a program, with and without GLuRay.
struct FrameImages {
  Pixels with, origin;                   // the run with GLuRay; one Origin for each of its pixels
  std::optional<Pixels> without;         // the run without; absent if it has no image
  uint64_t frame = 0, frameWithout = 0;  // counted from 1
  uint64_t elsewhere = 0;                // pixels traced into framebuffer objects
  bool perPixel = true;                  // lighting was evaluated at each pixel
  bool atRest = false;                   // the last frame of each run, not two frames of equal number
};

/// The page as HTML; `text` is the printed explanation. Throws std::runtime_error.
std::string htmlPage(const std::string& command, const std::string& text, const FrameImages& images);

/// The page's numbers as JSON.
nlohmann::json imageFacts(const FrameImages& images);

}  // namespace gluray::launcher

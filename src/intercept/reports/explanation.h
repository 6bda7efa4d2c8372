// Data about this process for `gluray explain`, besides the report's totals. Any thread.
#pragma once
#include "intercept/contexts/contexts.h"
#include "intercept/present/read_back/frame_image.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::intercept {

/// Records that the program looked up the OpenGL function `name`, which has no stub: GLuRay does not see
/// calls of it.
void noteUnknownFunction(const char* name) noexcept;

/// Stores the latest frame's image; the next report writes it to files.
void keepImage(present::RecordedImage image);

/// The report's section "explain". If there is a new image, writes it as BASE.ppm and BASE.origin.pgm.
nlohmann::json explanation(const Totals& totals, bool complete, const std::string& base);

}  // namespace gluray::intercept

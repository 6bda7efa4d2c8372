// What `gluray explain` wants to know of this process beside the report's sums. Any thread.
#pragma once
#include "intercept/contexts.h"
#include "intercept/present/read_back/frame_picture.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::intercept {

/// The program asked for the OpenGL function `name`, which no stub stands in for: its calls go to the real
/// OpenGL unseen.
void noteUnknownFunction(const char* name) noexcept;

/// The latest frame's picture. Written to files with the next report.
void keepPicture(present::Picture picture);

/// The part "explain" of the report. The picture's files are written as BASE.ppm and BASE.origin.pgm where
/// there is a newer one than last time.
nlohmann::json explanation(const Totals& totals, bool complete, const std::string& base);

}  // namespace gluray::intercept

// The settings of pictures, as users give them. Any thread.
#pragma once
#include "settings/settings.h"

#include <functional>
#include <string>
#include <vector>

namespace gluray::saved {

/// Settings with other values, "name=value" each; empty: the same settings. The result throws
/// std::runtime_error with one line if a value cannot be read.
std::function<Settings(const Settings&)> withValues(std::vector<std::string> values);

/// ShotOptions::edgeSamples: smooth edges in pictures of other sizes than the window's, unless the user chose
/// the samples.
int edgeSamplesFor(const std::vector<std::string>& values);

}  // namespace gluray::saved

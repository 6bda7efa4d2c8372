// Settings on the command lines of benchmarks.
#pragma once
#include "settings/settings.h"

#include <string>

namespace gluray::bench {

/// Sets what "NAME=VALUE" says. Throws std::runtime_error where there is no such setting or value.
void set(Settings&, const std::string& assignment);

}  // namespace gluray::bench

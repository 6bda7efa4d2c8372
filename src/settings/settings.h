// What the user chose. A plain value: the control thread or the launcher makes one, each snapshot carries
// one. spec/settings.toml describes every setting; the structs and enumerations are generated from it.
#pragma once
#include "settings/settings.gen.h"

#include <string>

namespace gluray {

/// Takes one line for the user about something that was not read.
using Complain = void (*)(const std::string& line);

/// Threads of one of `ranks` processes that share `cores` cores of a host, of which this one may run on
/// `allowed`: 0 (all it may use) where it runs alone or has cores of its own.
int threadsOfRank(int cores, int allowed, int ranks);

/// The settings of this process from all layers (settings/layers.h). An unreadable value is reported once
/// through `complain` ("GLURAY_BVH=x: use auto, fast, full, compact or least") and has no effect.
Session sessionFromEnvironment(Complain complain);

}  // namespace gluray

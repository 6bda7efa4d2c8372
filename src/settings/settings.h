// The user's settings. Plain values: the control thread or the launcher creates them, and each snapshot
// contains a copy. The structs and enumerations are generated from spec/settings.toml, which describes every
// setting.
#pragma once
#include "settings/settings.gen.h"

#include <functional>
#include <string>

namespace gluray {

/// Receives one line for the user about an entry that could not be read.
using Complain = std::function<void(const std::string& line)>;

/// Number of threads for one of `ranks` processes that share the `cores` cores of a host; this process may
/// use `allowed` of them. 0 (all that it may use) if it runs alone or is bound to cores of its own.
int threadsOfRank(int cores, int allowed, int ranks);

/// The same for this process. What batch systems say comes first (base/processes/usable_cores.h).
int threadsOfThisRank();

/// The settings of this process from all layers (settings/layers/settings_layers.h). Reports each unreadable
/// value once through `complain` ("GLURAY_BVH=x: use auto, fast, full, compact or least") and ignores it.
Session sessionFromEnvironment(const Complain& complain);

}  // namespace gluray

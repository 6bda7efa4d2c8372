// What the user asked for, read once when the engine starts. Any thread.
#pragma once
#include "settings/settings.h"

namespace gluray::intercept {

/// The session of this process; reads the environment at the first call.
const Session& session();

}  // namespace gluray::intercept

// What a context makes of the settings of a frame. GL thread.
#pragma once
#include "gl/context_info.h"

namespace gluray::gl {

/// Who draws: `automatic` holds only while the real OpenGL would show the same picture. Interception alone is
/// priced with everything held back.
Engine engineOf(const ContextInfo& info, const Settings& settings);

/// Threads that trace, as EngineChoice takes them into account.
int threadsOf(const Settings& settings);

}  // namespace gluray::gl

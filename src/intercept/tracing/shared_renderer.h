// The host process's renderer. Any thread.
#pragma once
#include "frame/tracing/renderer.h"

namespace gluray::intercept {

/// Made at the first call. Never destroyed: hosts call us while they exit.
frame::Renderer& sharedRenderer();

}  // namespace gluray::intercept

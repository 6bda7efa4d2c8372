// Look-up of our stubs for OpenGL commands by name. Called by the engine and tests; any thread.
#pragma once

namespace gluray::intercept {

/// Our function for the OpenGL command `name` ("glVertex3f"), aliases included; null for names that gl.xml
/// does not know.
void* stubProc(const char* name);

}  // namespace gluray::intercept

// The functions that programs call in place of OpenGL's, by name. Doors and tests ask; any thread.
#pragma once

namespace gluray::intercept {

/// Our function for the OpenGL command `name` ("glVertex3f"), aliases included; null for names that gl.xml
/// does not know.
void* stubProc(const char* name);

}  // namespace gluray::intercept

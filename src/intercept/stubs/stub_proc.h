// Finds GLuRay's stubs for OpenGL commands by name. Called by the engine and tests; any thread.
#pragma once

namespace gluray::intercept {

/// GLuRay's function for the OpenGL command `name` ("glVertex3f"), including aliases; null for names that
/// gl.xml does not contain.
void* stubProc(const char* name);

}  // namespace gluray::intercept

/* Like glad: opens libGL at run time, looks everything else up by glXGetProcAddressARB. */
#include "glx_client.h"

#include <dlfcn.h>

static void* (*getProcAddress)(const GLubyte*);
static void* byName(const char* name) { return getProcAddress((const GLubyte*)name); }

int main(void) {
  void* library = dlopen("libGL.so.1", RTLD_NOW | RTLD_GLOBAL);
  if (!library) return fprintf(stderr, "%s\n", dlerror()), 1;
  getProcAddress = (void* (*)(const GLubyte*))dlsym(library, "glXGetProcAddressARB");
  Gl gl;
  Glx glx;
  if (!getProcAddress || !loadGl(&gl, byName) || !loadGlx(&glx, byName)) return 1;
  return runGlxClient(&glx, &gl);
}

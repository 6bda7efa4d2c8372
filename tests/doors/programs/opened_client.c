/* Functions found with dlsym on a library opened at run time. Argument: local, deepbind, or five: the library
   is opened and closed five times before it is used. */
#define _GNU_SOURCE
#include "glx_client.h"

#include <dlfcn.h>
#include <string.h>

static void* library;
static void* fromLibrary(const char* name) { return dlsym(library, name); }

int main(int argc, char** argv) {
  const char* way = argc > 1 ? argv[1] : "local";
  const int flags = RTLD_LAZY | RTLD_LOCAL | (strcmp(way, "deepbind") == 0 ? RTLD_DEEPBIND : 0);
  for (int i = 0; strcmp(way, "five") == 0 && i < 5; ++i) {
    void* handle = dlopen("libGL.so.1", flags);
    if (!handle || !dlsym(handle, "glXSwapBuffers") || dlclose(handle) != 0)
      return fprintf(stderr, "%s\n", dlerror()), 1;
  }
  library = dlopen("libGL.so.1", flags);
  if (!library) return fprintf(stderr, "%s\n", dlerror()), 1;
  Gl gl;
  Glx glx;
  if (!loadGl(&gl, fromLibrary) || !loadGlx(&glx, fromLibrary)) return 1;
  const int failed = runGlxClient(&glx, &gl);
  return dlclose(library) != 0 || failed;
}

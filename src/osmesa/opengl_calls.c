#include "osmesa/opengl_calls.h"

#include <EGL/egl.h>
#include <dlfcn.h>
#include <pthread.h>
#include <stddef.h>
#include <string.h>

static Calls g_calls;
static int g_complete;

static void find(void) {
  static const struct {
    size_t place;
    const char* name;
  } kCalls[] = {
#define CALL(NAME) {offsetof(Calls, NAME), "gl" #NAME}
      CALL(BindBuffer),     CALL(BindFramebuffer), CALL(ClampColor), CALL(Finish),     CALL(Flush),
      CALL(GetIntegerv),    CALL(PixelStorei),     CALL(PopAttrib),  CALL(PushAttrib), CALL(PixelTransferf),
      CALL(PixelTransferi), CALL(ReadBuffer),      CALL(ReadPixels),
#undef CALL
  };
  void* const library = dlopen("libOpenGL.so.0", RTLD_LAZY | RTLD_LOCAL);
  g_complete = 1;
  for (size_t i = 0; i < sizeof kCalls / sizeof *kCalls; ++i) {
    void* call = library ? dlsym(library, kCalls[i].name) : NULL;
    if (!call) call = (void*)eglGetProcAddress(kCalls[i].name);
    memcpy((char*)&g_calls + kCalls[i].place, &call, sizeof call);
    if (!call) g_complete = 0;
  }
}

const Calls* osmesaCalls(void) {
  static pthread_once_t once = PTHREAD_ONCE_INIT;
  pthread_once(&once, find);
  return g_complete ? &g_calls : NULL;
}

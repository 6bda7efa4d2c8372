/* The preload door: for programs that ship their own OpenGL library, for OSMesa, and for systems without
   libglvnd. LD_PRELOAD loads it into the program and all its children, so it uses libc only, does nothing at
   load time and prints nothing. Its entry points are generated. This file contains the lookup of the real
   functions behind them, and every GetProcAddress. */
#define _GNU_SOURCE
#include "intercept/doors/door.h"
#include "intercept/doors/door_table.h"
#include "intercept/doors/real_libraries.h"
#include "intercept/doors/real_symbols.h"

#include <dlfcn.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))

typedef void* (*Lookup)(const char* name);

static int startsWith(const char* text, const char* start) { return !strncmp(text, start, strlen(start)); }

/* The real GetProcAddress of an API, the only function that finds all OpenGL functions of that API. */
static Lookup realLookup(int api) {
  static const char* const names[] = {"glXGetProcAddressARB", "eglGetProcAddress", "OSMesaGetProcAddress"};
  static Lookup found[3];
  Lookup lookup = __atomic_load_n(&found[api], __ATOMIC_RELAXED);
  if (!lookup) {
    lookup = (Lookup)glurayExported(api, names[api]);
    __atomic_store_n(&found[api], lookup, __ATOMIC_RELAXED);
  }
  return lookup;
}

static void* lookedUp(int api, const char* name) {
  const Lookup lookup = realLookup(api);
  void* function = lookup ? lookup(name) : NULL;
  return glurayIsOurs(function) ? NULL : function;
}

static void* realProc(const char* name, int api) {
  if (startsWith(name, "glX") || startsWith(name, "egl") || startsWith(name, "OSMesa")) {
    void* function = glurayExported(api, name);
    return function ? function : lookedUp(api, name);
  }
  if (api == GLURAY_API_ANY) {
    void* function = glurayOfProgram(name);
    return function ? function : lookedUp(GLURAY_API_GLX, name);
  }
  void* function = lookedUp(api, name);
  return function ? function
                  : glurayExported(api, name); /* before EGL 1.5 eglGetProcAddress finds extensions only */
}

const GlurayDoor glurayDoor = {GLURAY_DOOR_ABI, sizeof(GlurayDoor), GLURAY_DOOR_PRELOAD, realProc};

EXPORT void* glXGetProcAddress(const unsigned char* name);
EXPORT void* glXGetProcAddressARB(const unsigned char* name);
EXPORT void* eglGetProcAddress(const char* name);
EXPORT void* OSMesaGetProcAddress(const char* name);

/* Our function for a name, if the real library has a function of that name. */
static void* answer(int api, const char* name) {
  if (!name) return NULL;
  if (!strcmp(name, "glXGetProcAddress") || !strcmp(name, "glXGetProcAddressARB"))
    return (void*)glXGetProcAddress;
  if (!strcmp(name, "eglGetProcAddress")) return (void*)eglGetProcAddress;
  if (!strcmp(name, "OSMesaGetProcAddress")) return (void*)OSMesaGetProcAddress;
  void* real = lookedUp(api, name);
  if (!real) return NULL;
  if (glurayFind(name) < 0) {
    const GlurayEngine* engine = glurayEngineIfLoaded();
    void* ours = engine ? engine->proc(&glurayDoor, name) : NULL;
    return ours ? ours : real;
  }
  static void* self;
  void* handle = __atomic_load_n(&self, __ATOMIC_RELAXED);
  if (!handle) {
    handle = gluraySelf();
    __atomic_store_n(&self, handle, __ATOMIC_RELAXED);
  }
  void* ours = handle ? gluraySymbol(handle, name) : NULL;
  return ours ? ours : real;
}

void* glXGetProcAddress(const unsigned char* name) { return answer(GLURAY_API_GLX, (const char*)name); }
void* glXGetProcAddressARB(const unsigned char* name) { return answer(GLURAY_API_GLX, (const char*)name); }
void* eglGetProcAddress(const char* name) { return answer(GLURAY_API_EGL, name); }
void* OSMesaGetProcAddress(const char* name) { return answer(GLURAY_API_OSMESA, name); }

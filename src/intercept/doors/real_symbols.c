#define _GNU_SOURCE
#include "intercept/doors/real_symbols.h"

#include "intercept/doors/door.h"

#include <dlfcn.h>
#include <link.h>
#include <stddef.h>

typedef void* (*Dlsym)(void* restrict, const char* restrict);

/* The C library's dlsym, found by its version: overlays export dlsym without a version. */
static Dlsym realDlsym(void) {
  static Dlsym real;
  static const char* const versions[] = {"GLIBC_2.34", "GLIBC_2.17", "GLIBC_2.2.5"};
  Dlsym function = __atomic_load_n(&real, __ATOMIC_RELAXED);
  for (unsigned i = 0; !function && i < sizeof versions / sizeof *versions; ++i)
    function = (Dlsym)dlvsym(RTLD_NEXT, "dlsym", versions[i]);
  if (!function) function = dlsym;
  __atomic_store_n(&real, function, __ATOMIC_RELAXED);
  return function;
}

void* gluraySymbol(void* handle, const char* name) { return realDlsym()(handle, name); }

static struct link_map* objectOf(const void* function) {
  Dl_info info;
  struct link_map* map = NULL;
  return function && dladdr1(function, &info, (void**)&map, RTLD_DL_LINKMAP) ? map : NULL;
}

/* Whether the function's library exports its own dlsym. OpenGL functions are never in the C library. */
static int isOfOverlay(const void* function) {
  const struct link_map* object = objectOf(function);
  if (!object || !object->l_name || !*object->l_name) return 0;
  void* handle = dlopen(object->l_name, RTLD_LAZY | RTLD_NOLOAD);
  const int wraps = handle && objectOf(gluraySymbol(handle, "dlsym")) == object;
  if (handle) dlclose(handle);
  return wraps;
}

/* The function in the first library after this one in the search order that is not an overlay. */
static void* behindOverlays(const char* name) {
  const struct link_map* map = objectOf((const void*)&glurayDoor);
  while (map && (map = map->l_next)) {
    void* handle = dlopen(map->l_name, RTLD_LAZY | RTLD_NOLOAD);
    void* function = handle ? gluraySymbol(handle, name) : NULL;
    if (handle) dlclose(handle);
    if (function && !glurayIsOurs(function) && !isOfOverlay(function)) return function;
  }
  return NULL;
}

void* glurayNextSymbol(const char* name) {
  void* function = gluraySymbol(RTLD_NEXT, name);
  return function && isOfOverlay(function) ? behindOverlays(name) : function;
}

#define _GNU_SOURCE
#include "intercept/doors/real_libraries.h"

#include "intercept/doors/door.h"
#include "intercept/doors/real_symbols.h"

#include <dlfcn.h>
#include <string.h>

#define OPENED_MAX 8

/* Handles from the program's own dlopen calls. They are never closed, so that functions stay valid. */
static void* opened[GLURAY_LIB_COUNT][OPENED_MAX];

int glurayLibraryOf(const char* file) {
  static const struct {
    const char* name;
    int library;
  } names[] = {
      {"libGL.so", GLURAY_LIB_GL},           {"libGL.so.1", GLURAY_LIB_GL},
      {"libGLX.so", GLURAY_LIB_GL},          {"libGLX.so.0", GLURAY_LIB_GL},
      {"libOpenGL.so", GLURAY_LIB_GL},       {"libOpenGL.so.0", GLURAY_LIB_GL},
      {"libEGL.so", GLURAY_LIB_EGL},         {"libEGL.so.1", GLURAY_LIB_EGL},
      {"libOSMesa.so", GLURAY_LIB_OSMESA},   {"libOSMesa.so.6", GLURAY_LIB_OSMESA},
      {"libOSMesa.so.8", GLURAY_LIB_OSMESA},
  };
  const char* slash = strrchr(file, '/');
  const char* base = slash ? slash + 1 : file;
  for (unsigned i = 0; i < sizeof names / sizeof *names; ++i)
    if (!strcmp(base, names[i].name)) return names[i].library;
  return -1;
}

void glurayRemember(int library, void* handle) {
  for (int i = 0; i < OPENED_MAX; ++i) {
    void* expected = NULL;
    if (__atomic_compare_exchange_n(&opened[library][i], &expected, handle, 0, __ATOMIC_ACQ_REL,
                                    __ATOMIC_ACQUIRE))
      return;
    if (expected == handle) return;
  }
}

/* Returns the function, or null if it is ours. */
static void* accept(void* function) { return function && !glurayIsOurs(function) ? function : NULL; }

static void* ofSystem(int library, const char* name) {
  static const char* const files[GLURAY_LIB_COUNT][4] = {
      {"libGLX.so.0", "libOpenGL.so.0", "libGL.so.1"}, {"libEGL.so.1"}, {"libOSMesa.so.8", "libOSMesa.so.6"}};
  for (int i = 0; files[library][i]; ++i) {
    void* handle = dlopen(files[library][i], RTLD_LAZY | RTLD_LOCAL);
    void* function = handle ? accept(gluraySymbol(handle, name)) : NULL;
    if (function) return function;
  }
  return NULL;
}

static void* ofOpened(int library, const char* name) {
  void* function = NULL;
  for (int i = 0; !function && i < OPENED_MAX; ++i) {
    void* handle = __atomic_load_n(&opened[library][i], __ATOMIC_ACQUIRE);
    if (handle) function = accept(gluraySymbol(handle, name));
  }
  return function;
}

void* glurayExported(int library, const char* name) {
  void* function = accept(glurayNextSymbol(name));
  if (!function) function = ofOpened(library, name);
  return function ? function : ofSystem(library, name);
}

void* glurayOfProgram(const char* name) {
  void* function = accept(glurayNextSymbol(name));
  if (!function) function = ofOpened(GLURAY_LIB_GL, name);
  return function ? function : ofOpened(GLURAY_LIB_OSMESA, name);
}

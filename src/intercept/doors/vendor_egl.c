/* The GLVND door for EGL: a vendor library that wraps the real vendor. libEGL finds it through
   gluray_egl.json
   (__EGL_VENDOR_LIBRARY_FILENAMES). */
#include "intercept/doors/door.h"
#include "intercept/doors/door_table.h"

#include <dlfcn.h>
#include <glvnd/libeglabi.h>
#include <stdlib.h>
#include <string.h>

static __EGLapiImports real;

static void* realProc(const char* name, int api) {
  (void)api;
  return real.getProcAddress ? real.getProcAddress(name) : NULL;
}

const GlurayDoor glurayDoor = {GLURAY_DOOR_ABI, sizeof(GlurayDoor), GLURAY_DOOR_VENDOR_EGL, realProc};

static void* getProcAddress(const char* name) {
  void* function = realProc(name, GLURAY_API_EGL);
  if (!function) return NULL;
  const int entry = glurayFind(name);
  if (entry >= 0) return glurayJumps[entry];
  const GlurayEngine* engine = glurayEngineIfLoaded();
  void* ours = engine ? engine->proc(&glurayDoor, name) : NULL;
  return ours ? ours : function;
}

__attribute__((visibility("default"))) EGLBoolean __egl_Main(uint32_t version, const __EGLapiExports* exports,
                                                             __EGLvendorInfo* vendor,
                                                             __EGLapiImports* imports) {
  static void* handle;
  const char* chosen = getenv("GLURAY_REAL_EGL");
  if (!chosen || !*chosen) chosen = "libEGL_mesa.so.0";
  if (!handle) handle = dlopen(chosen, RTLD_LAZY | RTLD_LOCAL);
  if (!handle) {
    gluraySay("cannot load the real EGL; GLURAY_REAL_EGL says which", dlerror());
    return EGL_FALSE;
  }
  __PFNEGLMAINPROC realMain = (__PFNEGLMAINPROC)dlsym(handle, __EGL_MAIN_PROTO_NAME);
  if (!realMain) return EGL_FALSE;
  if (glurayIsOurs((const void*)realMain)) {
    gluraySay("the real EGL is GLuRay itself; GLURAY_REAL_EGL must name another library", NULL);
    return EGL_FALSE;
  }
  memset(&real, 0, sizeof real);
  if (!realMain(version, exports, vendor, imports)) return EGL_FALSE;
  real = *imports;
  imports->getProcAddress = getProcAddress;
  /* A vendor that patches libglvnd's entry points would lead calls past us. */
  imports->isPatchSupported = NULL;
  imports->initiatePatch = NULL;
  imports->releasePatch = NULL;
  imports->patchThreadAttach = NULL;
  return EGL_TRUE;
}

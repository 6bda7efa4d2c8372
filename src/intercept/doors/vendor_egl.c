/* The GLVND door for EGL: a vendor library that wraps the real vendor. libEGL finds it through
   gluray_egl.json (__EGL_VENDOR_LIBRARY_FILENAMES). The machine's vendor files follow in that list, so that
   programs have EGL if this door cannot be loaded. */
#define _GNU_SOURCE
#include "intercept/doors/door.h"
#include "intercept/doors/door_table.h"
#include "intercept/doors/real_symbols.h"

#include <dlfcn.h>
#include <glvnd/libeglabi.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static __EGLapiImports real;

static void* realProc(const char* name, int api) {
  (void)api;
  return real.getProcAddress ? real.getProcAddress(name) : NULL;
}

const GlurayDoor glurayDoor = {GLURAY_DOOR_ABI, sizeof(GlurayDoor), GLURAY_DOOR_VENDOR_EGL, realProc};

static int devicesAreAnothers; /* the real vendor is loaded a second time, and lists its devices itself */

static void* getProcAddress(const char* name) {
  if (devicesAreAnothers && !strcmp(name, "eglQueryDevicesEXT")) return NULL;
  void* function = realProc(name, GLURAY_API_EGL);
  if (!function) return NULL;
  const int entry = glurayFind(name);
  if (entry >= 0) return glurayJumps[entry];
  const GlurayEngine* engine = glurayEngineIfLoaded();
  void* ours = engine ? engine->proc(&glurayDoor, name) : NULL;
  return ours ? ours : function;
}

static const char* realVendor(void) {
  const char* chosen = getenv("GLURAY_REAL_EGL");
  return chosen && *chosen ? chosen : "libEGL_mesa.so.0";
}

static void* openRealVendor(void) {
  void* handle = dlopen(realVendor(), RTLD_LAZY | RTLD_LOCAL);
  if (!handle) gluraySay("cannot load the real EGL; GLURAY_REAL_EGL says which", dlerror());
  return handle;
}

/* libEGL's handle of this library. */
static void* ownHandle(void) {
  Dl_info info;
  if (!dladdr((const void*)&glurayDoor, &info) || !info.dli_fname) return NULL;
  return dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
}

/* Puts the real vendor's handle into libEGL's record in place of ours. libEGL does not load a library that
   one of its vendors has loaded: it compares the handles in the records. So a vendor file after ours does not
   load the real vendor again. The record begins with an identifier and the handle (libglvnd's
   src/EGL/libeglvendor.h, 1.0 to 1.7). */
static int standInFor(const char* library, __EGLvendorInfo* vendor) {
  enum { kMaxWords = 4 };
  void** const words = (void**)vendor;
  void* const own = ownHandle();
  for (int i = 0; own && i < kMaxWords; ++i) {
    if (words[i] != own) continue;
    void* const handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL); /* libEGL closes it */
    if (handle) words[i] = handle;
    return handle != NULL;
  }
  return 0;
}

/* Whether other vendor files follow ours. */
static int othersFollow(void) {
  const char* files = getenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  return files && strchr(files, ':');
}

/* Bytes of the tables of libglvnd's interface of this version. Later versions have only added functions at
 * the ends. */
static size_t exportsSize(uint32_t version) {
  const int devices = EGL_VENDOR_ABI_GET_MINOR_VERSION(version) >= 2;
  return devices ? sizeof(__EGLapiExports) : offsetof(__EGLapiExports, setVendorForDevice);
}
static size_t importsSize(uint32_t version) {
  const int platforms = EGL_VENDOR_ABI_GET_MINOR_VERSION(version) >= 1;
  return platforms ? sizeof(__EGLapiImports) : offsetof(__EGLapiImports, findNativeDisplayPlatform);
}

/* Starts the real vendor. A program may close libEGL and open it again: libEGL then initialises again, while
   this door and the real vendor stay loaded. The vendor may store its exports only at its first start, so it
   gets a copy that is kept up to date. */
static int startRealVendor(uint32_t version, const __EGLapiExports* exports, __EGLvendorInfo* vendor,
                           const __EGLapiImports* imports) {
  static void* handle;
  static __EGLapiExports lasting;
  if (EGL_VENDOR_ABI_GET_MAJOR_VERSION(version) != EGL_VENDOR_ABI_MAJOR_VERSION) {
    gluraySay("libglvnd has an interface that GLuRay does not know; use gluray --door preload", NULL);
    return 0;
  }
  if (!handle) handle = openRealVendor();
  __PFNEGLMAINPROC realMain = handle ? (__PFNEGLMAINPROC)gluraySymbol(handle, __EGL_MAIN_PROTO_NAME) : NULL;
  if (!realMain) return 0;
  if (glurayIsOurs((const void*)realMain)) {
    gluraySay("the real EGL is GLuRay itself; GLURAY_REAL_EGL must name another library", NULL);
    return 0;
  }
  __EGLapiImports filled = {0};
  memcpy(&filled, imports, importsSize(version));
  memcpy(&lasting, exports, exportsSize(version));
  if (!realMain(version, &lasting, vendor, &filled)) return 0;
  if (filled.getProcAddress) real = filled;
  devicesAreAnothers = !standInFor(realVendor(), vendor) && othersFollow();
  return real.getProcAddress != NULL;
}

__attribute__((visibility("default"))) EGLBoolean __egl_Main(uint32_t version, const __EGLapiExports* exports,
                                                             __EGLvendorInfo* vendor,
                                                             __EGLapiImports* imports) {
  glurayNoteStreams();
  if (glurayIsPrivileged() || !startRealVendor(version, exports, vendor, imports)) return EGL_FALSE;
  memcpy(imports, &real, importsSize(version));
  imports->getProcAddress = getProcAddress;
  /* A vendor that patches libglvnd's entry points would bypass GLuRay. */
  imports->isPatchSupported = NULL;
  imports->initiatePatch = NULL;
  imports->releasePatch = NULL;
  imports->patchThreadAttach = NULL;
  return EGL_TRUE;
}

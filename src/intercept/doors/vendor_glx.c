/* The GLVND door for GLX: a vendor library that wraps the real vendor. libGLX finds it under the name
   "gluray" (__GLX_VENDOR_LIBRARY_NAME). libGLX loads vendors in its constructor, so nothing here may use the
   X server. */
#include "intercept/doors/dispatch_first.h"
#include "intercept/doors/door.h"
#include "intercept/doors/door_table.h"
#include "intercept/doors/real_symbols.h"

#include <dlfcn.h>
#include <glvnd/libglxabi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static __GLXapiImports real;
static void* vendor; /* handle of the real vendor's library */

static void* ofVendor(const GLubyte* name) { return real.getProcAddress ? real.getProcAddress(name) : NULL; }

/* The real function, for a call that follows at once. */
static void* realProc(const char* name, int api) {
  (void)api;
  glurayDispatchFirst(vendor);
  return ofVendor((const GLubyte*)name);
}

static Bool isScreenSupported(Display* display, int screen) {
  glurayDispatchFirst(vendor);
  return real.isScreenSupported(display, screen);
}

const GlurayDoor glurayDoor = {GLURAY_DOOR_ABI, sizeof(GlurayDoor), GLURAY_DOOR_VENDOR_GLX, realProc};

/* libGLdispatch calls this for every OpenGL name at the first MakeCurrent, libGLX for its own functions when
 * it initialises. */
static void* getProcAddress(const GLubyte* procName) {
  const char* name = (const char*)procName;
  void* function = ofVendor(procName); /* also called from libGLX's constructor: does nothing else */
  if (!function) return NULL;
  const int entry = glurayFind(name);
  if (entry >= 0) return glurayJumps[entry];
  const GlurayEngine* engine = glurayEngineIfLoaded();
  void* ours = engine ? engine->proc(&glurayDoor, name) : NULL;
  return ours ? ours : function;
}

/* GLURAY_REAL_GLX is a vendor name ("mesa"), a library name or a path. */
static void* openRealVendor(void) {
  const char* chosen = getenv("GLURAY_REAL_GLX");
  char library[512];
  if (!chosen || !*chosen || !strcmp(chosen, "gluray")) chosen = "mesa";
  if (strchr(chosen, '/') || strstr(chosen, ".so"))
    snprintf(library, sizeof library, "%s", chosen);
  else
    snprintf(library, sizeof library, "libGLX_%s.so.0", chosen);
  void* handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  if (!handle) gluraySay("cannot load the real OpenGL; GLURAY_REAL_GLX says which", dlerror());
  return handle;
}

/* Starts the real vendor. A program may close libGL and open it again: libGLX then initialises again, while
   this door and the real vendor stay loaded. Mesa stores its exports only at its first start, so it gets a
   copy that is kept up to date, and its imports are kept. */
static int startRealVendor(uint32_t version, const __GLXapiExports* exports, __GLXvendorInfo* info,
                           const __GLXapiImports* imports) {
  static __GLXapiExports lasting;
  if (GLX_VENDOR_ABI_GET_MAJOR_VERSION(version) != GLX_VENDOR_ABI_MAJOR_VERSION ||
      version < GLX_VENDOR_ABI_VERSION) {
    gluraySay("libglvnd is too old; use gluray --door preload", NULL);
    return 0; /* its structures are smaller than ours */
  }
  if (!vendor) vendor = openRealVendor();
  __PFNGLXMAINPROC realMain = vendor ? (__PFNGLXMAINPROC)gluraySymbol(vendor, __GLX_MAIN_PROTO_NAME) : NULL;
  if (!realMain) return 0;
  if (glurayIsOurs((const void*)realMain)) {
    gluraySay("the real OpenGL is GLuRay itself; GLURAY_REAL_GLX must name another vendor", NULL);
    return 0;
  }
  __GLXapiImports filled = *imports;
  lasting = *exports;
  if (!realMain(version, &lasting, info, &filled)) return 0;
  if (filled.getProcAddress) real = filled;
  return real.getProcAddress != NULL;
}

__attribute__((visibility("default"))) Bool __glx_Main(uint32_t version, const __GLXapiExports* exports,
                                                       __GLXvendorInfo* info, __GLXapiImports* imports) {
  glurayNoteStreams();
  if (glurayIsPrivileged() || !startRealVendor(version, exports, info, imports)) return False;
  *imports = real;
  imports->getProcAddress = getProcAddress;
  imports->isScreenSupported = isScreenSupported;
  /* A vendor that patches libglvnd's entry points would bypass GLuRay. */
  imports->isPatchSupported = NULL;
  imports->initiatePatch = NULL;
  imports->releasePatch = NULL;
  imports->patchThreadAttach = NULL;
  return True;
}

#define _GNU_SOURCE
#include "intercept/doors/door.h"

#include "base/guarded_write.h"
#include "base/printable.h"
#include "base/processes/address_space.h"
#include "intercept/doors/door_table.h"
#include "intercept/doors/real_symbols.h"

#include <dlfcn.h>
#include <limits.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/auxv.h>
#include <unistd.h>

static pthread_once_t engineOnce = PTHREAD_ONCE_INIT;
static const GlurayEngine* engine;
static int engineFailed;

static pthread_once_t streamsOnce = PTHREAD_ONCE_INIT;
static GlurayOutput standardError;

static void noteStreams(void) { standardError = glurayStream(STDERR_FILENO); }

void glurayNoteStreams(void) { pthread_once(&streamsOnce, noteStreams); }

int glurayIsPrivileged(void) { return getauxval(AT_SECURE) != 0; }

/* Whether the launcher started exactly this process, or there is no launcher. */
static int mayTalk(void) {
  const char* launched = getenv("GLURAY_PID");
  return !launched || strtol(launched, NULL, 10) == (long)getpid();
}

void gluraySay(const char* line, const char* detail) {
  char text[1024];
  if (!mayTalk()) return;
  size_t length = (size_t)snprintf(text, sizeof text, "gluray: %s%s", line, detail ? ": " : "");
  if (detail) length += glurayPrintable(text + length, sizeof text - length, detail, strlen(detail));
  text[length] = '\n';
  int error = 0;
  glurayNoteStreams();
  glurayWrite(&standardError, text, length + 1, 0, &error);
}

/* Path of the engine: in the door's directory, unless GLURAY_ENGINE_LIBRARY names it. */
static void enginePath(char* path, size_t size) {
  const char* chosen = getenv("GLURAY_ENGINE_LIBRARY");
  Dl_info info;
  if (chosen && *chosen) {
    snprintf(path, size, "%s", chosen);
    return;
  }
  path[0] = 0;
  if (!dladdr((const void*)&glurayDoor, &info) || !info.dli_fname) return;
  const char* slash = strrchr(info.dli_fname, '/');
  snprintf(path, size, "%.*slibgluray-engine.so", slash ? (int)(slash - info.dli_fname + 1) : 0,
           info.dli_fname);
}

static void giveUp(const char* what, const char* why) {
  gluraySay(what, why);
  __atomic_store_n(&engineFailed, 1, __ATOMIC_RELEASE);
}

static void cannotLoad(const char* why) {
  giveUp("OpenGL is not ray traced in this program; reinstall GLuRay and its libraries, or run without it",
         why);
}

/* Whether the process's limits leave so little address space that libraries would run out of it and crash,
   such as the real OpenGL's compiler. If so, reports it. */
static int addressSpaceIsShort(void) {
  const unsigned long long least = glurayLoadBytes();
  char why[128];
  if (glurayAddressSpaceLeft() >= least) return 0;
  snprintf(why, sizeof why, GLURAY_ADDRESS_SPACE_IS_SHORT, least >> 20);
  giveUp("OpenGL is not ray traced in this program", why);
  return 1;
}

static void loadEngine(void) {
  char path[PATH_MAX];
  glurayNoteStreams();
  if (glurayIsPrivileged()) {
    __atomic_store_n(&engineFailed, 1, __ATOMIC_RELEASE);
    return;
  }
  if (addressSpaceIsShort()) return;
  enginePath(path, sizeof path);
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    cannotLoad(dlerror());
    return;
  }
  GlurayEngineEntry entry = (GlurayEngineEntry)gluraySymbol(library, GLURAY_ENGINE_ENTRY);
  const char* why = "the engine has no entry point";
  const GlurayEngine* loaded = entry ? entry(&glurayDoor, &why) : NULL;
  if (!loaded) {
    cannotLoad(why);
    return;
  }
  __atomic_store_n(&engine, loaded, __ATOMIC_RELEASE);
}

const GlurayEngine* glurayLoadEngine(void) {
  pthread_once(&engineOnce, loadEngine);
  return glurayEngineIfLoaded();
}

const GlurayEngine* glurayEngineIfLoaded(void) { return __atomic_load_n(&engine, __ATOMIC_ACQUIRE); }

int glurayEngineFailed(void) { return __atomic_load_n(&engineFailed, __ATOMIC_ACQUIRE); }

int glurayFind(const char* name) {
  int low = 0, high = glurayCount - 1;
  while (low <= high) {
    const int middle = (low + high) / 2;
    const int order = strcmp(name, glurayNames + glurayNameOffsets[middle]);
    if (order == 0) return middle;
    if (order < 0)
      high = middle - 1;
    else
      low = middle + 1;
  }
  return -1;
}

/* Set by the linker: start and end of this library in memory. */
extern const char __ehdr_start __attribute__((visibility("hidden")));
extern const char _end __attribute__((visibility("hidden")));

int glurayIsOurs(const void* function) {
  return (const char*)function >= &__ehdr_start && (const char*)function < &_end;
}

/* Functions that create a context: the first call of one loads the engine. */
static int makesContext(const char* name) {
  return strstr(name, "CreateContext") || strstr(name, "CreateNewContext") || strstr(name, "ImportContext");
}

static long doNothing(void) { return 0; }

static int apiOf(const char* name) {
  if (!strncmp(name, "glX", 3)) return GLURAY_API_GLX;
  if (!strncmp(name, "egl", 3)) return GLURAY_API_EGL;
  return strncmp(name, "OSMesa", 6) ? GLURAY_API_ANY : GLURAY_API_OSMESA;
}

void* glurayResolve(int i) {
  const char* name = glurayNames + glurayNameOffsets[i];
  const GlurayEngine* ready = makesContext(name) ? glurayLoadEngine() : glurayEngineIfLoaded();
  void* function = ready ? ready->proc(&glurayDoor, name) : NULL;
  if (!function) function = glurayDoor.realProc(name, apiOf(name));
  if (!function) return (void*)doNothing; /* searched again next time: its library may be loaded later */
  if (ready || glurayEngineFailed()) __atomic_store_n(&glurayTable[i], function, __ATOMIC_RELAXED);
  return function;
}

/* The binary interface between a door and the engine. Plain C. A door is a small library through which the
   program's OpenGL calls pass. The engine is libgluray-engine.so; it is loaded by the first door through
   which a context is created. */
#pragma once
#include <stdint.h>

#define GLURAY_DOOR_ABI 1u
#define GLURAY_ENGINE_ENTRY "glurayEngine"

#ifdef __cplusplus
extern "C" {
#endif

enum GlurayDoorKind { GLURAY_DOOR_VENDOR_GLX = 0, GLURAY_DOOR_VENDOR_EGL = 1, GLURAY_DOOR_PRELOAD = 2 };

/* The window system API for which a function is requested: if a process has two OpenGL libraries (libGL and
   libOSMesa), one name has two functions. ANY: the function that the program itself would get. Vendor doors
   serve one API and ignore the value. */
enum GlurayApi { GLURAY_API_GLX = 0, GLURAY_API_EGL = 1, GLURAY_API_OSMESA = 2, GLURAY_API_ANY = 3 };

/* Provided by the door. Lives as long as the process. */
typedef struct GlurayDoor {
  uint32_t version; /* GLURAY_DOOR_ABI */
  uint32_t size;    /* sizeof(GlurayDoor) */
  int kind;         /* enum GlurayDoorKind */
  /* The real function `name` ("glVertex3f", "glXSwapBuffers", "eglMakeCurrent"), or null. Never one of ours.
   * Any thread. */
  void* (*realProc)(const char* name, int api);
} GlurayDoor;

/* Provided by the engine. Lives as long as the process. */
typedef struct GlurayEngine {
  uint32_t version; /* GLURAY_DOOR_ABI */
  uint32_t size;    /* sizeof(GlurayEngine) */
  /* The function that the program gets for `name`, or null: use the real one. Any thread. Never throws. */
  void* (*proc)(const GlurayDoor* door, const char* name);
} GlurayEngine;

/* What doors call. Returns null if the door has another ABI version or the engine cannot start;
   `*why` is then a line that is never freed. May be called again, by this or another door. */
typedef const GlurayEngine* (*GlurayEngineEntry)(const GlurayDoor* door, const char** why);

#ifdef __cplusplus
}
#endif

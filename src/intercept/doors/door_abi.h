/* The contract between a door and the engine. Plain C. A door is a small library that the program's OpenGL
   calls pass through; the engine is libgluray-engine.so, loaded by the first door through which a context is
   made. */
#pragma once
#include <stdint.h>

#define GLURAY_DOOR_ABI 1u
#define GLURAY_ENGINE_ENTRY "glurayEngine"

#ifdef __cplusplus
extern "C" {
#endif

enum GlurayDoorKind { GLURAY_DOOR_VENDOR_GLX = 0, GLURAY_DOOR_VENDOR_EGL = 1, GLURAY_DOOR_PRELOAD = 2 };

/* Which window system API a function is wanted for: with two OpenGL libraries in one process (libGL and
   libOSMesa), the same name has two functions. ANY: what the program itself would have got. Vendor doors know
   one API and ignore it. */
enum GlurayApi { GLURAY_API_GLX = 0, GLURAY_API_EGL = 1, GLURAY_API_OSMESA = 2, GLURAY_API_ANY = 3 };

/* What the door gives. Lives as long as the process. */
typedef struct GlurayDoor {
  uint32_t version; /* GLURAY_DOOR_ABI */
  uint32_t size;    /* sizeof(GlurayDoor) */
  int kind;         /* enum GlurayDoorKind */
  /* The real function `name` ("glVertex3f", "glXSwapBuffers", "eglMakeCurrent"), or null. Never one of ours.
   * Any thread. */
  void* (*realProc)(const char* name, int api);
} GlurayDoor;

/* What the engine gives. Lives as long as the process. */
typedef struct GlurayEngine {
  uint32_t version; /* GLURAY_DOOR_ABI */
  uint32_t size;    /* sizeof(GlurayEngine) */
  /* The function to hand to the program for `name`, or null: use the real one. Any thread. Never throws. */
  void* (*proc)(const GlurayDoor* door, const char* name);
} GlurayEngine;

/* The engine's only export. Null if the door speaks another version or the engine cannot start; then `*why`
   is a static or never freed line. May be called again, by this or another door. */
typedef const GlurayEngine* (*GlurayEngineEntry)(const GlurayDoor* door, const char** why);

#ifdef __cplusplus
}
#endif

/* Calls the engine's entry point as a door of another version would. Argument: the engine. */
#include "intercept/doors/door_abi.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

static void* noFunction(const char* name, int api) { return (void)name, (void)api, NULL; }

int main(int argc, char** argv) {
  void* engine = argc > 1 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
  if (!engine) return fprintf(stderr, "%s\n", dlerror()), 1;
  const GlurayEngineEntry entry = (GlurayEngineEntry)dlsym(engine, GLURAY_ENGINE_ENTRY);
  const GlurayDoor stranger = {GLURAY_DOOR_ABI + 1, sizeof stranger, GLURAY_DOOR_PRELOAD, noFunction};
  const GlurayDoor friendly = {GLURAY_DOOR_ABI, sizeof friendly, GLURAY_DOOR_PRELOAD, noFunction};
  const char* why = NULL;
  if (!entry || entry(&stranger, &why) || !why || !strstr(why, "version"))
    return fprintf(stderr, "a stranger was let in\n"), 1;
  const GlurayEngine* one = entry(&friendly, &why);
  if (!one || one->version != GLURAY_DOOR_ABI || one != entry(&friendly, &why))
    return fprintf(stderr, "a friend was not let in, or not twice\n"), 1;
  /* Unknown names have no function; OpenGL's names do. */
  if (one->proc(&friendly, "glNoSuchCommand") || !one->proc(&friendly, "glVertex3f")) return 1;
  return 0;
}

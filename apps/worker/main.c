/* gluray-worker: runs the worker of libgluray-engine.so (worker_program.h), which lies where the launcher's
   does. In C: it needs no C++ library. */
#define _GNU_SOURCE
#include "options.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/auxv.h>
#include <unistd.h>

typedef int (*Worker)(const GlurayWorkerOptions*, int, char**);

/* The folder of this program's file. Without /proc, that of the name by which it was started. Returns whether
 * it is known. */
static int ownFolder(char folder[PATH_MAX]) {
  const char* const started = (const char*)getauxval(AT_EXECFN);
  if (!realpath("/proc/self/exe", folder) && (!started || !realpath(started, folder))) return 0;
  char* const slash = strrchr(folder, '/');
  if (slash) *slash = 0;
  return slash != NULL;
}

static int fail(const char* what, const char* more) {
  fprintf(stderr, "gluray-worker: %s%s\n", what, more);
  return 1;
}

int main(int argc, char** argv) {
  static const char* const ways[] = {"../lib/gluray", "../../lib/gluray"};
  char folder[PATH_MAX] = "", place[PATH_MAX + 64], engine[PATH_MAX];
  GlurayWorkerOptions options;
  int exitCode = 0;
  if (!readOptions(argc, argv, &options, &exitCode)) return exitCode;
  if (!ownFolder(folder)) return fail("where this program lies is not known: mount /proc", "");
  for (size_t i = 0; i < sizeof ways / sizeof *ways; ++i) {
    snprintf(place, sizeof place, "%s/%s/libgluray-engine.so", folder, ways[i]);
    if (!realpath(place, engine)) continue;
    void* const library = dlopen(engine, RTLD_NOW | RTLD_LOCAL);
    if (!library) return fail(dlerror(), "");
    Worker work = NULL;
    *(void**)&work = dlsym(library, "glurayWorker");
    return work ? work(&options, argc, argv)
                : fail("install GLuRay again: another one's library is ", engine);
  }
  return fail("install GLuRay again: its libraries are missing beside ", folder);
}

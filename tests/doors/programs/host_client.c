/* A program that does not link libGL: it opens it, makes a context, and then opens the plug-in, which draws.
   host_client PLUGIN lazy|now|global|deepbind|early|glx: how the plug-in is opened; early: before the context
   is made; glx: lazy, and the program opens libGLX alone. */
#define _GNU_SOURCE
#include "glx_client.h"
#include "plugin.h"

#include <dlfcn.h>
#include <string.h>

static void* library;
static void* fromLibrary(const char* name) { return dlsym(library, name); }

static int flagsOf(const char* way) {
  if (!strcmp(way, "now")) return RTLD_NOW | RTLD_LOCAL;
  if (!strcmp(way, "global")) return RTLD_LAZY | RTLD_GLOBAL;
  if (!strcmp(way, "deepbind")) return RTLD_LAZY | RTLD_LOCAL | RTLD_DEEPBIND;
  return RTLD_LAZY | RTLD_LOCAL;
}

static void* open(const char* file, int flags) {
  void* handle = dlopen(file, flags);
  if (handle) return handle;
  fprintf(stderr, "%s\n", dlerror());
  exit(1);
}

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const char* way = argv[2];
  library = open(strcmp(way, "glx") ? "libGL.so.1" : "libGLX.so.0", RTLD_LAZY | RTLD_LOCAL);
  void* plugin = strcmp(way, "early") ? NULL : open(argv[1], flagsOf(way));
  Glx glx;
  if (!loadGlx(&glx, fromLibrary)) return 1;
  Client client = openClient(&glx);
  GLXContext context = glx.CreateContext(client.display, client.visual, NULL, True);
  if (!context || !glx.MakeCurrent(client.display, client.window, context))
    return fprintf(stderr, "no context\n"), 1;
  if (!plugin) plugin = open(argv[1], flagsOf(way));
  int (*draw)(void (*)(void*), void*) = (int (*)(void (*)(void*), void*))dlsym(plugin, "pluginDraw");
  const int right = draw && draw(showClient, &client);
  glx.MakeCurrent(client.display, None, NULL);
  glx.DestroyContext(client.display, context);
  closeClient(&client);
  return !right;
}

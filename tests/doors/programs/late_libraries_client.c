/* Draws, and then opens the libraries that its arguments name: prints which file each name gave. */
#define _GNU_SOURCE
#include "linked.h"

#include <dlfcn.h>
#include <link.h>
#include <stdio.h>

int main(int argc, char** argv) {
  const Gl gl = linkedGl();
  const Glx glx = linkedGlx();
  const int outcome = runGlxClient(&glx, &gl);
  for (int i = 1; i < argc; ++i) {
    void* library = dlopen(argv[i], RTLD_NOW | RTLD_GLOBAL);
    struct link_map* map = NULL;
    if (!library || dlinfo(library, RTLD_DI_LINKMAP, &map) != 0) return 3;
    printf("opened %s\n", map->l_name);
  }
  return outcome;
}

/* Functions of dlopen that must still work under the preload door. Arguments: a bare library name that only
   this program's RUNPATH leads to, then the same for a bare libGL.so.1. Prints where the second came from. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  void* plain = dlopen(argv[1], RTLD_NOW);
  if (!plain) return fprintf(stderr, "%s\n", dlerror()), 1;
  if (dlopen("libnowhere-at-all.so", RTLD_NOW)) return 1;
  if (!strstr(dlerror(), "libnowhere-at-all.so")) return 1;
  void* gl = dlopen("libGL.so.1", RTLD_NOW);
  if (!gl) return fprintf(stderr, "%s\n", dlerror()), 1;
  const unsigned char* (*getString)(unsigned) = (const unsigned char* (*)(unsigned))dlsym(gl, "glGetString");
  if (!getString) return fprintf(stderr, "no glGetString\n"), 1;
  const unsigned char* text = getString(0x1F02);
  printf("%s\n", text ? (const char*)text : "none");
  return 0;
}

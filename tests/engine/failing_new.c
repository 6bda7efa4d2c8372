/* Preloaded: of the allocations by `new` in the engine's code, number $FAIL_AT (from 1) throws
   std::bad_alloc, as when memory is short. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <link.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* Called at every allocation, so it avoids dladdr, which searches all symbols of the caller's library. */
static int isOfEngine(const void* address) {
  struct dl_find_object found;
  return _dl_find_object((void*)address, &found) == 0 &&
         strstr(found.dlfo_link_map->l_name, "libgluray-engine.so");
}

static void* allocate(size_t size, const void* caller) {
  static atomic_long asked;
  static atomic_long wanted;
  if (wanted == 0) {
    const char* at = getenv("FAIL_AT");
    wanted = at ? atol(at) : -1;
  }
  void* memory = wanted > 0 && isOfEngine(caller) && ++asked == wanted ? NULL : malloc(size ? size : 1);
  if (memory) return memory;
  void (*throwBadAlloc)(void);
  *(void**)&throwBadAlloc = dlsym(RTLD_DEFAULT, "_ZSt17__throw_bad_allocv");
  throwBadAlloc();
  return NULL;
}

__attribute__((visibility("default"))) void* _Znwm(size_t size) {
  return allocate(size, __builtin_return_address(0));
}
__attribute__((visibility("default"))) void* _Znam(size_t size) {
  return allocate(size, __builtin_return_address(0));
}

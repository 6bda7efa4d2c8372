#define _GNU_SOURCE
#include "intercept/doors/dispatch_first.h"

#include "intercept/doors/real_symbols.h"

#include <dlfcn.h>
#include <stddef.h>

/* libglvnd's library of that name. Null if it is another library, because programs may ship their own. */
static void* ofDispatch(const char* name) {
  void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
  return library && gluraySymbol(library, "__glDispatchInit") ? library : NULL;
}

/* Takes no lock and waits for no other thread: a thread that loads a library may hold the dynamic linker's
 * lock. */
void glurayDispatchFirst(void* vendor) {
  static int done;
  if (!vendor || __atomic_load_n(&done, __ATOMIC_ACQUIRE)) return;
  const char* const libraries[] = {"libGL.so.1", "libOpenGL.so.0"};
  for (int i = 0; i < 2 && gluraySymbol(vendor, "glDrawArrays"); ++i)
    if (ofDispatch(libraries[i])) dlopen(libraries[i], RTLD_LAZY | RTLD_GLOBAL);
  __atomic_store_n(&done, 1, __ATOMIC_RELEASE);
}
